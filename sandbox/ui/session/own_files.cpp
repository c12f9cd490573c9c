#include "ui/session/own_files.h"

#include "image/error.h"
#include "shading/own_text.h"
#include "ui/session/session.h"

#include <set>
#include <system_error>

namespace sandbox {

namespace {

void forget_failure(Session &session, const std::string &file) { session.own_failures.erase(file); }

} // namespace

bool is_own_name(const std::filesystem::path &path) { return path.extension() == ".glsl"; }

void open_own(Session &session, const std::filesystem::path &file) {
    const std::string path = std::filesystem::absolute(file).lexically_normal().string();
    const OwnShader own = read_own(path);
    Document document = session.document;
    document.left = {.frequency = document.left.model == Model::own ? document.left.frequency : Frequency::per_pixel,
                     .model = Model::own};
    document.left.own = own;
    document.textbook.reset();
    show_document(session, document);
    session.last_own = own;
    forget_failure(session, path);
}

OwnShader own_of(const Session &session, bool right) {
    const OwnShader &shown = session.technique(right).own;
    return shown ? shown : session.technique(!right).own ? session.technique(!right).own : session.last_own;
}

std::string own_failure(const Session &session, bool right) {
    const Technique &technique = session.technique(right);
    if (technique.model != Model::own) {
        return {};
    }
    const auto found = session.own_failures.find(technique.own->file);
    return found == session.own_failures.end() ? std::string() : found->second;
}

bool OwnFiles::read_saved(Session &session) {
    std::set<std::string> files;
    for (const Technique *side : {&session.document.left, &session.document.right}) {
        if (side->own) {
            files.insert(side->own->file);
        }
    }
    bool changed = false;
    for (const std::string &file : files) {
        std::error_code absent, gone; // for a moment, while an editor saves
        const State now{std::filesystem::last_write_time(file, absent), std::filesystem::file_size(file, gone)};
        if (absent || gone) {
            seen_[file] = {}; // whatever it is when it is there again, it is new
            continue;
        }
        const auto [known, is_new] = seen_.try_emplace(file, now);
        if (is_new || known->second == now) {
            continue;
        }
        known->second = now;
        changed = true;
        try {
            const OwnShader own = read_own(file);
            Document document = session.document;
            for (Technique *side : {&document.left, &document.right}) {
                if (side->own && side->own->file == file) {
                    side->own = own;
                }
            }
            show_document(session, document);
            session.last_own = own;
            forget_failure(session, file);
        } catch (const InputError &error) {
            session.own_failures[file] = error.what();
        }
    }
    return changed;
}

} // namespace sandbox
