// One step up the bloom pyramid: a level is blurred and blended onto the next larger one (Jimenez 2014, "Next
// generation post processing in Call of Duty"). The four bilinear taps are as wide as a 3x3 tent filter.
uniform sampler2D uSource;
uniform vec2 uTexel;  // 1 / size of the source
in vec2 uv;
out vec4 result;

void main() {
    vec2 away = uTexel * 0.7071;
    vec3 sum = texture(uSource, uv - away).rgb + texture(uSource, uv + away).rgb +
               texture(uSource, uv + vec2(away.x, -away.y)).rgb + texture(uSource, uv + vec2(-away.x, away.y)).rgb;
    result = vec4(sum * 0.25, 1.0);
}
