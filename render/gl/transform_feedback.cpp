#include "render/gl/transform_feedback.h"

namespace rubble {

TransformFeedback TransformFeedback::current() {
    GLboolean isActive = GL_FALSE, isPaused = GL_FALSE;
    if (GLAD_GL_ARB_transform_feedback2) glGetBooleanv(GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE, &isActive);
    if (isActive) glGetBooleanv(GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED, &isPaused);
    return {isActive && !isPaused};
}

void TransformFeedback::pause() const {
    if (isActive) glPauseTransformFeedback();
}

void TransformFeedback::resume() const {
    if (isActive) glResumeTransformFeedback();
}

}  // namespace rubble
