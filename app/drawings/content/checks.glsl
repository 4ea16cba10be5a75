  if (flChecks > 0.0) {
    vec2 flST = flAffine > 0 ? flScreenST.xy / flScreenST.z : flSpaceST;
    if (flCoordinates > 0) {
      gl_FragData[0].rgb = vec3(clamp(flST, 0.0, 1.0), 0.0);
    } else {
      vec2 flCheck = floor(flST * flChecks);
      if (mod(flCheck.x + flCheck.y, 2.0) > 0.5) gl_FragData[0].rgb *= 0.3;
    }
  }
