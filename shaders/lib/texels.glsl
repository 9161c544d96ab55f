// Arrays that shaders read by index (render/gl/texture.h, BufferTexture), of one, two or four numbers an element:
// `uniform texels2 uWords;` is read by fetch2(uWords, i). Each is a buffer texture, as that is fastest. Contexts with
// small buffer textures or few texture units get SHARED_TEXELS, and WebGL2 would: there all arrays of a format lie in
// one texture of layers, and a uniform is the number of the array's first texel (render/gl/shared_texels.h).
#ifdef SHARED_TEXELS
#define texels1 int
#define texels2 int
#define texels4 int
#define texels4f int
uniform usampler2DArray uTexels1;
uniform usampler2DArray uTexels2;
uniform usampler2DArray uTexels4;
ivec3 texelPlace(int i) {
    const int mask = (1 << SHARED_TEXELS) - 1;
    return ivec3(i & mask, i >> SHARED_TEXELS & mask, i >> (2 * SHARED_TEXELS));
}
#define fetch1(array, i) texelFetch(uTexels1, texelPlace((array) + (i)), 0).r
#define fetch2(array, i) texelFetch(uTexels2, texelPlace((array) + (i)), 0).rg
#define fetch4(array, i) texelFetch(uTexels4, texelPlace((array) + (i)), 0)
#define fetch4f(array, i) uintBitsToFloat(texelFetch(uTexels4, texelPlace((array) + (i)), 0))
#else
#define texels1 usamplerBuffer
#define texels2 usamplerBuffer
#define texels4 usamplerBuffer
#define texels4f samplerBuffer
#define fetch1(array, i) texelFetch(array, i).r
#define fetch2(array, i) texelFetch(array, i).rg
#define fetch4(array, i) texelFetch(array, i)
#define fetch4f(array, i) texelFetch(array, i)
#endif
