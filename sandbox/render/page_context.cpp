#include "render/page_context.h"

#include "image/error.h"

#include <emscripten/html5.h>
#include <emscripten/html5_webgl.h>

extern "C" void page_add_canvas(const char *name); // sandbox/page/browser.js

namespace sandbox {
namespace {

/// WebGL 2 of one canvas.
class Canvas {
  public:
    explicit Canvas(const char *canvas) {
        EmscriptenWebGLContextAttributes attributes;
        emscripten_webgl_init_context_attributes(&attributes);
        attributes.majorVersion = 2;
        attributes.alpha = attributes.antialias = attributes.stencil = false;
        attributes.preserveDrawingBuffer = true; // a frame that changes nothing is not drawn
        attributes.powerPreference = EM_WEBGL_POWER_PREFERENCE_HIGH_PERFORMANCE;
        context_ = emscripten_webgl_create_context(canvas, &attributes);
        if (context_ <= 0) {
            throw MachineError("this browser gives the page no WebGL 2: try a newer browser, or switch its hardware "
                               "acceleration on (chrome://gpu, about:support say what is off)");
        }
        emscripten_webgl_enable_extension(context_, "WEBGL_debug_renderer_info"); // the renderer's name
    }
    ~Canvas() { emscripten_webgl_destroy_context(context_); }
    Canvas(const Canvas &) = delete;
    Canvas &operator=(const Canvas &) = delete;

    void use() const {
        if (emscripten_webgl_make_context_current(context_) != EMSCRIPTEN_RESULT_SUCCESS) {
            throw MachineError("the browser has taken WebGL away: reload the page");
        }
    }

  private:
    EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context_ = 0;
};

/// A canvas that nobody sees.
class HiddenCanvas : public Canvas {
  public:
    HiddenCanvas() : Canvas((page_add_canvas(name), name)) {}

  private:
    static constexpr const char *name = "!hidden";
};

class CanvasWorker final : public WorkerContext {
  private:
    void make_current() const override { canvas_.use(); }
    void release() const override {}

    HiddenCanvas canvas_;
};

template <class Kind> class CanvasContext final : public Context {
  public:
    template <class... Name> explicit CanvasContext(Name... name) : canvas_(name...) {
        canvas_.use();
        load_functions(Profile::es, nullptr);
    }
    void make_current() const override { canvas_.use(); }
    [[nodiscard]] std::unique_ptr<WorkerContext> make_worker() const override {
        auto worker = std::make_unique<CanvasWorker>();
        make_current();
        return worker;
    }

  private:
    Kind canvas_;
};

} // namespace

std::unique_ptr<Context> make_canvas_context() { return std::make_unique<CanvasContext<Canvas>>("#canvas"); }

std::unique_ptr<Context> Context::headless(Backend, Profile) { return std::make_unique<CanvasContext<HiddenCanvas>>(); }

} // namespace sandbox
