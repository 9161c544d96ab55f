#include "render/gl/compatibility_state.h"

namespace rubble {
namespace {

// Names that headers for core profiles lack.
constexpr GLenum kAlphaTest = 0x0BC0, kPolygonStipple = 0x0B42, kMapColor = 0x0D10, kClampFragmentColor = 0x891B;

}  // namespace

CompatibilityState CompatibilityState::current() {
    CompatibilityState state;
    state.alphaTest = glIsEnabled(kAlphaTest);
    state.polygonStipple = glIsEnabled(kPolygonStipple);
    glGetIntegerv(kClampFragmentColor, &state.clampFragment);
    glGetBooleanv(kMapColor, &state.mapColor);
    for (size_t i = 0; i < kTransfers.size(); ++i) glGetFloatv(kTransfers[i], &state.transfers[i]);
    return state;
}

void CompatibilityState::set() const {
    alphaTest ? glEnable(kAlphaTest) : glDisable(kAlphaTest);
    polygonStipple ? glEnable(kPolygonStipple) : glDisable(kPolygonStipple);
    glClampColor(kClampFragmentColor, GLenum(clampFragment));
    setPixelTransfer(kMapColor, mapColor);
    for (size_t i = 0; i < kTransfers.size(); ++i) setPixelTransfer(kTransfers[i], transfers[i]);
}

}  // namespace rubble
