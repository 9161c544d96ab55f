// A smaller level spread over the next larger one, onto which it is blended: a tent of nine taps.
uniform sampler2D uSource;
uniform vec2 uTexel;   // 1 / size of the source
in vec2 uv;
out vec4 result;

void main() {
    vec3 sum = vec3(0.0);
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            sum += texture(uSource, uv + uTexel * vec2(x, y)).rgb * float((2 - abs(x)) * (2 - abs(y)));
    result = vec4(sum / 16.0, 1.0);
}
