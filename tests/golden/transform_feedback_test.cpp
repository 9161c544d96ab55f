// A host's transform feedback that is going on while the renderer draws.
#include "tests/golden/drawing.h"

namespace rubble {
namespace {

constexpr glm::ivec2 kSize(48, 32);
constexpr int kVertices = 8;

/// Captures one number a vertex: 100 + its index.
GLuint makeProgram() {
    const char* source = "#version 330 core\nout float value; void main() { value = 100.0 + float(gl_VertexID); }";
    const char* names[] = {"value"};
    const GLuint shader = glCreateShader(GL_VERTEX_SHADER), program = glCreateProgram();
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
    glTransformFeedbackVaryings(program, 1, names, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glDeleteShader(shader);
    return program;
}

class TransformFeedbackTest : public Drawing, public testing::WithParamInterface<HostState> {
protected:
    void SetUp() override {
        Drawing::SetUp();
        if (!GLAD_GL_ARB_transform_feedback2) GTEST_SKIP() << "transform feedback cannot be paused";
        RenderSettings settings;
        settings.hostState = GetParam();
        start(streetScene(), kSize, settings);
        m_plain = drawn();
        m_program = makeProgram();
        glGenTransformFeedbacks(1, &m_object), glGenBuffers(1, &m_buffer), glGenVertexArrays(1, &m_array);
        glGenQueries(1, &m_query);
        glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, m_object);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, m_buffer);
        glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, kVertices * sizeof(float), nullptr, GL_STATIC_READ);
        glUseProgram(m_program);
        glBindVertexArray(m_array);
    }
    void TearDown() override {
        glBindTransformFeedback(GL_TRANSFORM_FEEDBACK, 0);
        glUseProgram(0);
        glBindVertexArray(0);
        glDeleteTransformFeedbacks(1, &m_object), glDeleteBuffers(1, &m_buffer), glDeleteVertexArrays(1, &m_array);
        glDeleteQueries(1, &m_query), glDeleteProgram(m_program);
        Drawing::TearDown();
    }
    std::vector<uint8_t> drawn() {
        View view = streetCamera(0).view(kSize, target->framebuffer());
        view.cut = true;
        renderer->draw(view, 1.0f);
        return target->readRgb();
    }
    static std::vector<GLint> stateNow() {
        std::vector<GLint> all;
        for (const GLenum each :
             {GL_TRANSFORM_FEEDBACK_BUFFER_ACTIVE, GL_TRANSFORM_FEEDBACK_BUFFER_PAUSED, GL_TRANSFORM_FEEDBACK_BINDING})
            glGetIntegerv(each, &all.emplace_back());
        return all;
    }
    /// Draws a frame and expects it to be the usual one, and the host's state to stay.
    void expectUsualFrame() {
        const std::vector<GLint> before = stateNow();
        const std::vector<uint8_t> image = drawn();
        EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
        EXPECT_EQ(stateNow(), before);
        EXPECT_EQ(image, m_plain);
    }
    GLuint m_program = 0, m_object = 0, m_buffer = 0, m_array = 0, m_query = 0;
    std::vector<uint8_t> m_plain;
};

TEST_P(TransformFeedbackTest, ThatIsBoundStaysBound) {
    expectUsualFrame();
}

TEST_P(TransformFeedbackTest, ThatIsPausedStaysPaused) {
    glBeginTransformFeedback(GL_POINTS);
    glPauseTransformFeedback();
    expectUsualFrame();
    if (GetParam() == HostState::Restored) glResumeTransformFeedback();
    glEndTransformFeedback();
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

/// Not with HostState::Reset: there nothing is asked, and it must have ended or be paused.
class ActiveTransformFeedbackTest : public TransformFeedbackTest {};

TEST_P(ActiveTransformFeedbackTest, CapturesTheHostsVerticesOnly) {
    glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, m_query);
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, 3);
    expectUsualFrame();
    glDrawArrays(GL_POINTS, 3, 3);
    glEndTransformFeedback();
    glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
    GLuint written = 0;
    glGetQueryObjectuiv(m_query, GL_QUERY_RESULT, &written);
    EXPECT_EQ(written, 6u);
    float values[6] = {};
    glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof values, values);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(values[i], 100.0f + float(i));
    EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

INSTANTIATE_TEST_SUITE_P(Restored, ActiveTransformFeedbackTest, testing::Values(HostState::Restored));
INSTANTIATE_TEST_SUITE_P(Each, TransformFeedbackTest, testing::Values(HostState::Restored, HostState::Reset));

}  // namespace
}  // namespace rubble
