  gl_FragDepth = gl_FragCoord.z;
  if (flBuffer > 0) {
    float flW = flUnit / gl_FragCoord.w;
    float flR = 1.0 - gl_FragCoord.z;
    if (flMapping == 1) flR = flA * (1.0 - flW * flInverseFar) / flW;
    if (flMapping == 2) flR = flA * -log2(flW * flInverseFar);
    flR = clamp(flR, 0.0, 1.0);
    float flKey = flR;
    if (flBuffer == 1) {
      flKey = roundEven(flR * flSteps);
    } else {
      if (flBuffer == 2) flKey = flByNdc > 0.0 ? flByNdc * (1.0 - 2.0 * flR) + flByNdc : 1.0 - flR;
      if (flSteps > 0.0) {
        float flPower = exp2(max(floor(log2(max(flKey, 1e-30))), -14.0));
        flKey = roundEven(flKey / flPower * flSteps) / flSteps * flPower;
      }
      if (flBuffer == 2) flKey = 1.0 - flKey;
    }
    flKey *= flScale;
    if (flLog > 0.0) gl_FragDepth = clamp(flLog * -log2(max(flKey, 1e-37)), 0.0, 1.0);
    else gl_FragDepth = 1.0 - flKey;
  }
