// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A repeat's light as seen from the view's middle. What it gives may be averaged: flat.frag multiplies it by the yarns' colours.
uniform sampler2DArray repeat_picture; // see RepeatPicture
uniform vec3 to_eye;
uniform vec2 wound;                    // tangents of the angles of twist, of ends and of picks

out vec4 color; // light of ends and of picks; how much is covered

// A texel's normal times the light that reaches it, and that light.
vec4 layer(int which)
{
    vec4 texel = texelFetch(repeat_picture, ivec3(gl_FragCoord.xy, which), 0);
    return vec4((texel.xyz * 255.0 - 128.0) / 127.0, texel.w);
}

float light_of(vec4 skin, vec3 along, float twisted, vec3 lamp)
{
    if (skin.w <= 0.0)
        return 0.0;
    vec3 n = normalize(skin.xyz);
    return skin.w * matt_light(n, fibre_direction(n, along, twisted), lamp, to_eye, side);
}

void main()
{
    vec3 lamp = lamp_from(to_eye, side);
    int first = side > 0.0 ? 0 : 2;
    float covered = texelFetch(repeat_picture, ivec3(gl_FragCoord.xy, 4), 0).r;
    float ends = light_of(layer(first), vec3(0.0, 1.0, 0.0), wound.x, lamp);
    float picks = light_of(layer(first + 1), vec3(1.0, 0.0, 0.0), wound.y, lamp);
    color = vec4(ends, picks, covered, 1.0);
}
