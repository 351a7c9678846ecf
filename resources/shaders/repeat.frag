// A repeat's light as seen from the view's middle. What it gives may be averaged: flat.frag multiplies it by the yarns' colours.
uniform sampler2DArray repeat_picture; // see RepeatPicture
uniform vec3 to_eye;

out vec4 color; // light of ends and of picks; how much is covered

// A texel's normal times the light that reaches it, and that light.
vec4 layer(int which)
{
    vec4 texel = texelFetch(repeat_picture, ivec3(gl_FragCoord.xy, which), 0);
    return vec4((texel.xyz * 255.0 - 128.0) / 127.0, texel.w);
}

float light_of(vec4 skin, vec3 lamp)
{
    return skin.w > 0.0 ? skin.w * matt_light(normalize(skin.xyz), lamp, side) : 0.0;
}

void main()
{
    vec3 lamp = lamp_from(to_eye, side);
    int first = side > 0.0 ? 0 : 2;
    float covered = texelFetch(repeat_picture, ivec3(gl_FragCoord.xy, 4), 0).r;
    color = vec4(light_of(layer(first), lamp), light_of(layer(first + 1), lamp), covered, 1.0);
}
