// Kinds of particles: as ParticleKind in runtime/frame/frame_snapshot.h.
const int kDust = 0, kSmoke = 1, kFlame = 2, kSpark = 3, kCrumb = 4, kGlint = 5, kEmber = 6;
