// As VTK's own, in one loop of four texels: round the pixel, at its corners, then along the edge.
void main()
{
  ivec2 size = textureSize(Input, 0), last = size - 1;
  ivec2 place = ivec2(texCoord * size);
  vec4 centre = texelFetch(Input, place, 0);
  ivec2 low = max(place - 1, ivec2(0)), high = min(place + 1, last);
  ivec2 p0 = ivec2(place.x, low.y), p1 = ivec2(place.x, high.y);
  ivec2 p2 = ivec2(low.x, place.y), p3 = ivec2(high.x, place.y);
  vec3 sum = centre.rgb;
  vec4 beside = vec4(0.0), ends = vec4(0.0);
  ivec2 along = ivec2(0), across = ivec2(0);
  float here = luminosity(centre.rgb), there = 0.0, contrast = 0.0;
  bool isFlat = false, isLevel = false, isLowDone = false, isHighDone = false;
  ivec2 far = ivec2(1);  // to the lower and the higher end, in pixels
  for (int i = 0; i < EndpointSearchIterations + 2; ++i)
    {
    vec3 a = texelFetch(Input, p0, 0).rgb, b = texelFetch(Input, p1, 0).rgb;
    vec3 c = texelFetch(Input, p2, 0).rgb, d = texelFetch(Input, p3, 0).rgb;
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
      p0 = ivec2(high.x, low.y); p1 = high; p2 = low; p3 = ivec2(low.x, high.y);
      }
    else
      {
      if (i == 1)
        {
        float upright = 2.0 * abs(beside.z + beside.w - 2.0 * here)
          + abs(seen.z + seen.x - 2.0 * beside.x) + abs(seen.w + seen.y - 2.0 * beside.y);
        float level = 2.0 * abs(beside.x + beside.y - 2.0 * here)
          + abs(seen.z + seen.w - 2.0 * beside.z) + abs(seen.x + seen.y - 2.0 * beside.w);
        isLevel = level / 12.0 >= upright / 12.0;  // as VTK rounds it
        vec2 pair = isLevel ? beside.xy : beside.zw;
        bool isFirst = abs(here - pair.x) >= abs(here - pair.y);
        there = isFirst ? pair.x : pair.y;
        across = (isFirst ? -1 : 1) * (isLevel ? ivec2(0, 1) : ivec2(1, 0));
        along = isLevel ? ivec2(1, 0) : ivec2(0, 1);
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
        far += ivec2(isLowDone ? 0 : 1, isHighDone ? 0 : 1);
        }
      p1 = clamp(place - far.x * along, ivec2(0), last);
      p3 = clamp(place + far.y * along, ivec2(0), last);
      p0 = clamp(p1 + across, ivec2(0), last);
      p2 = clamp(p3 + across, ivec2(0), last);
      }
    }
  float end = far.x < far.y ? ends.y : ends.w;
  float part = abs(end - there) < abs(end - here)
    ? 0.5 - float(min(far.x, far.y)) / float(far.x + far.y) : 0.0;
  float spread = abs(0.25 * (beside.x + beside.y + (beside.z + beside.w)) - here) / contrast;
  float soft = max(0.0, spread - SubpixelContrastThreshold) / (1.0 - SubpixelContrastThreshold);
  vec3 edge = mix(centre.rgb, texelFetch(Input, clamp(place + across, ivec2(0), last), 0).rgb, part);
  vec3 smoothed = mix(edge, sum / 9.0, min(SubpixelBlendLimit, soft));
  fragOutput0 = isFlat ? centre : vec4(smoothed, centre.a);
}
