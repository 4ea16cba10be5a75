  float flAway = dot(flDistance, vec4(flObject.xyz, 1.0));
  float flHere = flAway < flUntil.x ? 0.0 : flAway < flUntil.y ? 1.0 : 2.0;
  if (flHere != flObject.w) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
