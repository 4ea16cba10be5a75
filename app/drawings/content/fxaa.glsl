vec3 at(vec2 place)
{
  ivec2 size = textureSize(Input, 0);
  return texelFetch(Input, clamp(ivec2(place * size), ivec2(0), size - 1), 0).rgb;
}

// As VTK's own, in one loop of four texels: round the pixel, at its corners, then along the edge.
void main()
{
  vec2 one = InvTexSize;
  vec4 centre = texelFetch(Input, ivec2(texCoord * textureSize(Input, 0)), 0);
  vec4 xs = texCoord.x + one.x * vec4(0.0, 0.0, -1.0, 1.0);
  vec4 ys = texCoord.y + one.y * vec4(-1.0, 1.0, 0.0, 0.0);
  vec3 sum = centre.rgb;
  vec4 beside = vec4(0.0), ends = vec4(0.0);
  vec2 along = vec2(0.0), across = vec2(0.0);
  float here = luminosity(centre.rgb), there = 0.0, contrast = 0.0;
  bool isFlat = false, isLevel = false, isLowDone = false, isHighDone = false;
  for (int i = 0; i < EndpointSearchIterations + 2; ++i)
    {
    vec3 a = at(vec2(xs.x, ys.x)), b = at(vec2(xs.y, ys.y));
    vec3 c = at(vec2(xs.z, ys.z)), d = at(vec2(xs.w, ys.w));
    vec4 seen = vec4(luminosity(a), luminosity(b), luminosity(c), luminosity(d));
    sum += i < 2 ? a + b + c + d : vec3(0.0);
    if (i == 0)
      {
      beside = seen;
      float least = min(here, min(min(seen.x, seen.y), min(seen.z, seen.w)));
      float most = max(here, max(max(seen.x, seen.y), max(seen.z, seen.w)));
      contrast = most - least;
      isFlat = contrast < max(HardContrastThreshold, RelativeContrastThreshold * most);
      if (isFlat) break;
      xs = texCoord.x + one.x * vec4(1.0, 1.0, -1.0, -1.0);
      ys = texCoord.y + one.y * vec4(-1.0, 1.0, -1.0, 1.0);
      }
    else if (i == 1)
      {
      float upright = 2.0 * abs(beside.z + beside.w - 2.0 * here)
        + abs(seen.z + seen.x - 2.0 * beside.x) + abs(seen.w + seen.y - 2.0 * beside.y);
      float level = 2.0 * abs(beside.x + beside.y - 2.0 * here)
        + abs(seen.z + seen.w - 2.0 * beside.z) + abs(seen.x + seen.y - 2.0 * beside.w);
      isLevel = level / 12.0 >= upright / 12.0;  // as VTK rounds it
      vec2 pair = isLevel ? beside.xy : beside.zw;
      bool isFirst = abs(here - pair.x) >= abs(here - pair.y);
      there = isFirst ? pair.x : pair.y;
      across = (isFirst ? -1.0 : 1.0) * (isLevel ? vec2(0.0, one.y) : vec2(one.x, 0.0));
      along = isLevel ? vec2(one.x, 0.0) : vec2(0.0, one.y);
      vec2 other = texCoord + across;
      xs = vec4(other.x, texCoord.x, other.x, texCoord.x) + along.x * vec4(-1.0, -1.0, 1.0, 1.0);
      ys = vec4(other.y, texCoord.y, other.y, texCoord.y) + along.y * vec4(-1.0, -1.0, 1.0, 1.0);
      }
    else
      {
      if (!isLowDone) ends.xy = seen.xy;
      if (!isHighDone) ends.zw = seen.zw;
      isLowDone = isLowDone || abs(ends.x - there) > abs(ends.x - here)
        || abs(ends.y - here) > abs(ends.y - there);
      isHighDone = isHighDone || abs(ends.z - there) > abs(ends.z - here)
        || abs(ends.w - here) > abs(ends.w - there);
      if (isLowDone && isHighDone) break;
      vec4 ways = vec4(vec2(isLowDone ? 0.0 : -1.0), vec2(isHighDone ? 0.0 : 1.0));
      xs += ways * along.x;
      ys += ways * along.y;
      }
    }
  vec2 away = isLevel ? vec2(texCoord.x - xs.y, xs.w - texCoord.x)
    : vec2(texCoord.y - ys.y, ys.w - texCoord.y);
  float end = away.x < away.y ? ends.y : ends.w;
  float part = abs(end - there) < abs(end - here)
    ? 0.5 - min(away.x, away.y) / (away.x + away.y) : 0.0;
  float spread = abs(0.25 * (beside.x + beside.y + (beside.z + beside.w)) - here) / contrast;
  float soft = max(0.0, spread - SubpixelContrastThreshold) / (1.0 - SubpixelContrastThreshold);
  vec3 edge = mix(centre.rgb, at(texCoord + across), part);
  vec3 smoothed = mix(edge, sum / 9.0, min(SubpixelBlendLimit, soft));
  fragOutput0 = isFlat ? centre : vec4(smoothed, centre.a);
}
