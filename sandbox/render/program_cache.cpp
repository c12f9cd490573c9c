#include "render/program_cache.h"

#include "image/device_limit.h"
#include "shading/template.h"

#include <algorithm>

namespace sandbox {
namespace {

constexpr std::size_t most_programs = 32; // unless late frames drew more
constexpr long late_frames = 8;           // of two views, with what else is drawn for them

} // namespace

void ProgramCache::build(Entry &entry, const Key &key) {
    const auto &[features, constants] = key;
    try {
        const ProgramSource source = with_constants(assemble(features, parts_), constants);
        if (features.is_own()) {
            require_es(source);
        }
        entry.program = std::make_shared<const GlProgram>(source);
        entry.last_good = false;
        ++built_;
    } catch (const DeviceLimitError &) { // no text is at fault
        throw;
    } catch (const std::exception &failure) { // ShaderError, or a part's directive that does not read
        error_ = failure.what();
        if (entry.program == nullptr && features.is_own()) {
            throw InputError(error_);
        }
        if (entry.program == nullptr) {
            throw ShaderError(error_);
        }
        entry.last_good = true;
    }
    entry.stale = false;
}

const GlProgram &ProgramCache::get(const Features &features, const UniformValues &constants) {
    auto found = entries_.find(Asked(features, constants));
    if (found == entries_.end()) {
        found = entries_.try_emplace({features, constants}).first;
    }
    Entry &entry = found->second;
    if (entry.program == nullptr || entry.stale) {
        build(entry, found->first);
    }
    entry.last_frame = frames_;
    return *entry.program;
}

bool ProgramCache::has(const Features &features, const UniformValues &constants) const {
    const auto found = entries_.find(Asked(features, constants));
    return found != entries_.end() && found->second.program != nullptr && !found->second.stale;
}

const GlProgram &ProgramCache::overlay(const std::string &name, bool deep) {
    auto found = overlays_.find({name, deep});
    if (found == overlays_.end()) {
        TemplateValues values;
        values.flags["deep"] = deep;
        const ProgramSource source{expand(parts_, name + "_vertex.glsl", values),
                                   expand(parts_, name + "_fragment.glsl", values)};
        found = overlays_.try_emplace({name, deep}, source).first;
    }
    return found->second;
}

void ProgramCache::rebuild_all() {
    error_.clear();
    for (auto &[key, entry] : entries_) {
        entry.stale = true;
    }
}

void ProgramCache::forget_last_good() {
    std::erase_if(entries_, [](const auto &entry) { return entry.second.stale || entry.second.last_good; });
}

void ProgramCache::forget_unused() {
    while (entries_.size() > most_programs) {
        const auto oldest = std::ranges::min_element(entries_, {}, [](const auto &entry) {
            return std::pair(entry.second.last_good, entry.second.last_frame); // nothing builds a last good one again
        });
        if (oldest->second.last_good || oldest->second.last_frame >= frames_ - late_frames) {
            break;
        }
        entries_.erase(oldest);
    }
}

} // namespace sandbox
