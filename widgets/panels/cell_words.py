"""Sentences about a matrix cell: its value, its effect and what it depends on."""

from PySide6.QtCore import QObject

from app.lecture.letters import Letters, written
from app.lecture.notation import WrittenMatrix
from app.lecture.titles import stage_title
from widgets.panels.matrix_view import VIEW, is_a_cameras
from widgets.parts.messages import field_name, read_text

_ONLY_W = (0.0, 0.0, 0.0, 1.0)


class CellWords(QObject):
    """Explains cells in a lecture's letters."""

    def sentence(
        self,
        matrix: WrittenMatrix,
        row: int,
        column: int,
        letters: Letters,
        *,
        rows: bool,
        typed: bool,
    ) -> str:
        """Explain a cell; `rows` if vectors are rows, `typed` if it can be typed."""
        value, formula = matrix.values[row][column], matrix.formulas[row][column]
        cell, number = written(formula, letters), read_text(value)
        if cell.replace("−", "-") == number.replace("−", "-"):
            cell = number
        else:
            cell = f"{cell} = {number}"
        fields = ", ".join(map(field_name, matrix.fields[row][column]))
        depends = self.tr("It depends on no control.")
        if fields:
            depends = self.tr("It depends on: {0}.").format(fields)
        into, of = (column, row) if rows else (row, column)
        w_row = tuple(each[3] for each in matrix.values) if rows else matrix.values[3]
        place = self.tr("row {0}, column {1}").format(row + 1, column + 1)
        invitation = self.tr(
            "Double-click or press Enter to type another number, or a fraction such as 1/3."
        )
        axes = "u", "v", written("axis_n", letters)
        parts = (
            f"{stage_title(matrix.name)}, {place}: {cell}.",
            self._to_w(matrix, of, value, w_row)
            if into == 3
            else self._of_camera(matrix, into, of, value, axes)
            or self._to_xyz(into, of, value, w_row),
            *((invitation,) if typed else ()),
            depends,
        )
        return " ".join(parts)

    def _of_camera(
        self, matrix: WrittenMatrix, into: int, of: int, value: float, axes: tuple[str, ...]
    ) -> str:
        """Describe the effect of a component of the camera's axes or eye; empty for other cells."""
        target, source = "xyzw"[into], "xyzw"[of]
        if of < 3 and matrix.name in VIEW and is_a_cameras(matrix):
            text = self.tr(
                "The world's {1} component of the camera's axis {0}: it adds {3} times {1} to {2}."
            )
            return text.format(axes[into], source, target, read_text(value))
        if matrix.name != "world_from_view":
            return ""
        if of == 3:
            text = self.tr("The {0} of the eye, where view space has its origin.")
            return text.format(target)
        text = self.tr("The world's {1} component of the camera's axis {0}.")
        return text.format(axes[of], target)

    def _to_xyz(self, into: int, of: int, value: float, w_row: tuple[float, ...]) -> str:
        if into == of:
            text = self.tr("It scales {0} by {2}.")
            if value == 1.0:
                text = self.tr("It leaves the scale of {0} unchanged.")
            elif value < 0.0:
                text = self.tr("It scales {0} by {2}, which reverses its direction.")
        elif of < 3:
            text = self.tr("It adds {2} times {1} to {0}: a shear.")
            if value == 0.0:
                text = self.tr("{0} does not depend on {1}.")
        elif value == 0.0:
            text = self.tr("It does not shift {0}.")
        elif w_row == _ONLY_W:
            text = self.tr("It shifts {0} by {2}.")
        else:
            text = self.tr("It adds {2} to {0} before the divide, and so {2}/w to the quotient.")
        return text.format("xyzw"[into], "xyzw"[of], read_text(value))

    def _to_w(self, matrix: WrittenMatrix, of: int, value: float, w_row: tuple[float, ...]) -> str:
        source, is_alone = "xyzw"[of], sum(map(bool, w_row)) == 1
        text = self.tr("It adds {1} times {0} to w, the divisor.")
        if value == 0.0:
            text = self.tr("w does not depend on {0}.")
        elif source == "w" and is_alone:
            text = self.tr("It scales w, the divisor, by {1}.")
            if value == 1.0:
                text = self.tr("It leaves w unchanged.")
        elif source == "z" and value == -1.0 and is_alone:
            text = self.tr("It makes w, the divisor, the distance −z: perspective.")
        elif source == "w" and matrix.name.endswith("_from_world"):  # where every w is 1
            text = self.tr("It adds {1} to w, the divisor.")
        named = self.tr("the incoming w") if source == "w" else source
        return text.format(named, read_text(value))
