"use strict";
(() => {
  const lines = (id) => document.getElementById(id).textContent.split("\n").slice(1);
  const parts = lines("parts"), states = lines("states");
  const slots = document.querySelectorAll("[data-slot]");
  const slider = document.querySelector("input"), value = document.querySelector("output");
  const shown = states[slider.defaultValue].split(";");
  const show = () => {
    states[slider.value].split(";").forEach((runs, slot) => {
      if (shown[slot] === runs) return;
      shown[slot] = runs;
      slots[slot].innerHTML = runs.split(",").map((run) => {
        const [first, last] = run.split("-").map((end) => parseInt(end, 36));
        return parts.slice(first, (last ?? first) + 1).join("");
      }).join("");
    });
    slider.setAttribute("aria-valuetext", value.textContent);
  };
  slider.addEventListener("input", show);
  slider.form.hidden = false;
  show();
})();
