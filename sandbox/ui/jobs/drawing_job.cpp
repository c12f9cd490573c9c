#include "ui/jobs/drawing_job.h"

#include "image/error.h"

#include <GLFW/glfw3.h>
#include <string>

namespace sandbox {

WorkerContext::WorkerContext() {
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE); // the other hints are as the window set them
    window_ = glfwCreateWindow(1, 1, "measuring", nullptr, nullptr);
    if (window_ == nullptr) {
        const char *reason = nullptr;
        glfwGetError(&reason);
        throw MachineError(std::string("no second OpenGL context can be had: ") +
                           (reason != nullptr ? reason : "no reason given"));
    }
}

WorkerContext::~WorkerContext() { glfwDestroyWindow(window_); }

WorkerContext::Current::Current(const WorkerContext &context) { glfwMakeContextCurrent(context.window_); }
WorkerContext::Current::~Current() { glfwMakeContextCurrent(nullptr); }

void wake_window() { glfwPostEmptyEvent(); }

} // namespace sandbox
