  if (flFog > 0) {
    float flW = flUnit / gl_FragCoord.w;
    if (flSpan > 0.0) flW = flNear + flSpan * gl_FragCoord.z;
    float flLeft = flFog == 1 ? clamp((flFogEnd - flW) * flFogSlope, 0.0, 1.0)
                              : exp(-flFogSlope * max(flW, 0.0));
    gl_FragData[0].rgb = mix(flBackground, gl_FragData[0].rgb, flLeft);
  }
