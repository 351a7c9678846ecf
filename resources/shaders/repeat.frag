// A repeat's light as seen from the view's middle. What it gives may be averaged: flat.frag multiplies it by the yarns' colours.
uniform sampler2DArray repeat_picture; // see RepeatPicture
uniform vec3 to_eye;

out vec4 color; // light of ends and of picks, three quarters of it; how much is covered

vec4 layer(int which)
{
    vec4 texel = texelFetch(repeat_picture, ivec3(gl_FragCoord.xy, which), 0);
    return vec4((texel.xyz * 255.0 - 128.0) / 127.0, texel.w);
}

void main()
{
    vec3 lamp = lamp_direction(to_eye);
    int first = side > 0.0 ? 0 : 2;
    vec4 warp = layer(first), weft = layer(first + 1);
    float covered = texelFetch(repeat_picture, ivec3(gl_FragCoord.xy, 4), 0).r;
    color = vec4(0.75 * light_on(vec3(1.0), warp.xyz, warp.w, lamp).r, 0.75 * light_on(vec3(1.0), weft.xyz, weft.w, lamp).r, covered, 1.0);
}
