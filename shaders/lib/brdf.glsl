// The specular BRDF: Cook-Torrance with the GGX distribution. For view v, light l, half vector h and alpha a:
//   f = D(h) F(v.h) G2(v, l) / (4 n.v n.l)
//   D = a^2 / (pi ((n.h)^2 (a^2 - 1) + 1)^2)                       GGX (Walter et al. 2007, eq. 33)
//   F = f0 + (1 - f0) (1 - v.h)^5                                   Schlick 1994
//   G2 = height-correlated Smith; with L(x) = sqrt(n.x^2 (1 - a^2) + a^2) it joins the denominator to
//   G2 / (4 n.v n.l) = 0.5 / (n.l L(v) + n.v L(l))                  Heitz 2014, eq. 99
// sampleVisibleNormal() draws h in proportion to the visible normals D_v = G1(v) v.h D / n.v. Reflected about h, that
// is a direction with the density D_v / (4 v.h) = D G1 / (4 n.v) = 0.5 D / (n.v + L(v))    (Heitz 2018).
#include "lib/constants.glsl"

const float kPaneReflectance = 0.05;  // of one face of a pane at normal incidence
const float kPaneScale = 1.6;         // a pane has two faces: it reflects that much more than one

/// Schlick's approximation of Fresnel's reflectance; f0 is that at normal incidence.
vec3 fresnel(vec3 f0, float cosine) {
    float m = 1.0 - clamp(cosine, 0.0, 1.0);
    float m2 = m * m;
    return f0 + (1.0 - f0) * m2 * m2 * m;
}

/// Fresnel's reflectance for light from all around. Rough surfaces reflect less at grazing angles: Schlick's term is
/// clamped by the smoothness (Lagarde 2011, "Adopting a physically based shading model").
vec3 fresnelRough(vec3 f0, float cosine, float roughness) {
    float m = 1.0 - clamp(cosine, 0.0, 1.0);
    float m2 = m * m;
    float smoothness = 1.0 - roughness;
    return f0 + (max(vec3(smoothness * smoothness), f0) - f0) * m2 * m2 * m;
}

float ggxAlpha(float roughness) { return max(roughness * roughness, 0.003); }

/// D of the GGX distribution at the half vector of v and l; a2 is alpha squared.
float ggxDistribution(vec3 n, vec3 v, vec3 l, float a2) {
    float nh = clamp(dot(n, normalize(v + l)), 0.0, 1.0);
    float d = nh * nh * (a2 - 1.0) + 1.0;
    return a2 / (kPi * d * d);
}

/// The BRDF without Fresnel's factor, 1 / sr.
float specularLobe(vec3 n, vec3 v, vec3 l, float roughness) {
    float alpha = ggxAlpha(roughness);
    float a2 = alpha * alpha;
    float nl = clamp(dot(n, l), 1e-4, 1.0);
    float nv = clamp(dot(n, v), 1e-4, 1.0);
    float distribution = ggxDistribution(n, v, l, a2);
    float masking = nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2);
    return distribution * 0.5 / max(masking, 1e-5);
}

/// Density over solid angle of directions l that v is reflected to about sampleVisibleNormal().
float ggxVndfPdf(vec3 n, vec3 v, vec3 l, float roughness) {
    float alpha = ggxAlpha(roughness);
    float a2 = alpha * alpha;
    float nv = clamp(dot(n, v), 1e-4, 1.0);
    return ggxDistribution(n, v, l, a2) * 0.5 / (nv + sqrt(nv * nv * (1.0 - a2) + a2));
}

/// Share of a light's highlight that comes from the lobe above. On smooth surfaces mirror rays bring the rest, from the
/// emissive voxels of the light.
float analyticHighlightShare(float roughness) { return smoothstep(0.1, 0.25, roughness); }
