#pragma once
#include <cstdint>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x2.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// One thing of an overlay: what is drawn over the finished image. Colours are sRGB with opacity, 0 to 1. An item lies
/// on a surface: the view, in pixels from its left upper corner, or a plane in the world.
struct OverlayItem {
    enum class Kind {
        Text,       ///< `text` in `font`
        Box,        ///< a rectangle of `size`
        Image,      ///< the image that is named `text`, over `size`
        Line,       ///< from (0, 0) to `size`
        WorldLine,  ///< from plane.position to `end`
    };
    /// A plane in the world: x to the right and y down, in units of `scale` metres.
    struct Plane {
        glm::dvec3 position{0.0};
        glm::dquat rotation{1, 0, 0, 0};
        double scale = 0.01;
        bool facesCamera = false;  ///< rotation is the camera's
        bool isOccluded = false;   ///< voxels that are nearer hide it
    };
    Kind kind = Kind::Box;
    std::string text;
    std::string font;             ///< Fonts::find()
    float fontSize = 16.0f;       ///< height of a line's letters: one em
    glm::vec2 size{0.0f};         ///< of a text: x is the width at which lines are broken, 0: none
    glm::mat3x2 transform{1.0f};  ///< from the item to its surface
    glm::vec2 align{0.0f};        ///< the point of it that is at (0, 0): 0 its left or upper side, 1 the other one
    bool isOnBaseline = false;    ///< of a text: y = 0 is the first baseline instead
    glm::vec4 color{1.0f};
    std::optional<glm::vec4> clip;             ///< left, top, right, bottom of the surface: nothing is drawn outside
    glm::vec4 source{0.0f, 0.0f, 1.0f, 1.0f};  ///< left, top, right, bottom of the image, in shares
    float radius = 0.0f;                       ///< of a box's corners
    float stroke = 0.0f;                       ///< width of a line, or of a box's border; 0: a box is filled
    float outline = 0.0f;                      ///< width round the letters of a text
    glm::vec4 outlineColor{0.0f, 0.0f, 0.0f, 1.0f};
    glm::vec2 shadowOffset{0.0f};
    float shadowBlur = 0.0f;
    glm::vec4 shadowColor{0.0f};  ///< a text has a shadow if it has opacity
    std::optional<Plane> plane;   ///< none: the view
    glm::dvec3 end{0.0};          ///< world, metres
};

/// An image for items, rows from the top, RGBA with straight alpha.
struct OverlayImage {
    glm::ivec2 size{0};
    std::vector<uint8_t> pixels;
};

}  // namespace rubble
