/// Schlick's approximation; f0 is the reflectance straight on.
vec3 fresnel(vec3 f0, float cosine) {
    float m = 1.0 - clamp(cosine, 0.0, 1.0);
    float m2 = m * m;
    return f0 + (1.0 - f0) * m2 * m2 * m;
}

/// Fresnel for light gathered from all around: a rough surface shows less of its edge (after Lagarde's clamp of Schlick's term).
vec3 fresnelRough(vec3 f0, float cosine, float roughness) {
    float m = 1.0 - clamp(cosine, 0.0, 1.0);
    float m2 = m * m;
    float smoothness = 1.0 - roughness;
    return f0 + (max(vec3(smoothness * smoothness), f0) - f0) * m2 * m2 * m;
}

float ggxAlpha(float roughness) { return max(roughness * roughness, 0.003); }

/// GGX: how many of its ggxDistribution mirror v to l (Walter et al. 2007).
float ggxDistribution(vec3 n, vec3 v, vec3 l, float a2) {
    float nh = clamp(dot(n, normalize(v + l)), 0.0, 1.0);
    float d = nh * nh * (a2 - 1.0) + 1.0;
    return a2 / (3.14159265 * d * d);
}

/// GGX with Smith's height-correlated masking, without fresnel: radiance out per irradiance in (cosine not included).
/// Walter et al. 2007; Heitz 2014.
float specularLobe(vec3 n, vec3 v, vec3 l, float roughness) {
    float alpha = ggxAlpha(roughness);
    float a2 = alpha * alpha;
    float nl = clamp(dot(n, l), 1e-4, 1.0);
    float nv = clamp(dot(n, v), 1e-4, 1.0);
    float distribution = ggxDistribution(n, v, l, a2);
    float masking = nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2);
    return distribution * 0.5 / max(masking, 1e-5);
}

/// Density of the directions that sampleVisibleNormal() mirrors v to: D G1 / (4 n.v) (Heitz 2018).
float ggxVndfPdf(vec3 n, vec3 v, vec3 l, float roughness) {
    float alpha = ggxAlpha(roughness);
    float a2 = alpha * alpha;
    float nv = clamp(dot(n, v), 1e-4, 1.0);
    return ggxDistribution(n, v, l, a2) * 0.5 / (nv + sqrt(nv * nv * (1.0 - a2) + a2));
}

/// Share of a lamp that a surface shows by the lobe above; the mirror rays of smooth ones bring the rest from its glowing voxels.
float analyticHighlightShare(float roughness) { return smoothstep(0.1, 0.25, roughness); }
