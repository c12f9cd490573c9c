#include "ui/session/playback.h"

#include "image/error.h"
#include "ui/session/session.h"

#include <algorithm>
#include <utility>

namespace sandbox {

namespace {

/// False, with a message and stopped, where the scene has no such motion.
bool possible(Session &session) {
    try {
        static_cast<void>(moved(session.document.scene, session.playback.motion, session.playback.moment));
        return true;
    } catch (const InputError &error) {
        stop_motion(session);
        session.message = {error.what(), true};
        return false;
    }
}

} // namespace

Document shown_document(const Session &session) {
    Document document = session.document;
    const Playback &play = session.playback;
    if (play.shown) {
        try {
            document.scene = moved(document.scene, play.motion, play.moment);
        } catch (const InputError &) {
            return document; // next_moment() says why
        }
    }
    return document;
}

void play_or_pause(Session &session) {
    if (possible(session)) {
        session.playback.playing = !session.playback.playing;
        session.playback.shown = true;
    }
}

void step_motion(Session &session, int moments) {
    if (possible(session)) {
        Playback &play = session.playback;
        play.playing = false;
        play.shown = true;
        const int round = moments_of(play.motion);
        play.moment = (play.moment + moments % round + round) % round;
    }
}

void next_moment(Session &session) {
    if (session.playback.playing && possible(session)) {
        step_motion(session, 1);
        session.playback.playing = true;
    }
}

void stop_motion(Session &session) {
    session.playback.playing = session.playback.shown = false;
    session.playback.moment = 0;
}

void keep_moment(Session &session) {
    const Document kept = shown_document(session);
    stop_motion(session);
    show_document(session, kept);
}

void choose_motion(Session &session, Motion motion) {
    stop_motion(session);
    motion.seconds = session.playback.motion.seconds;
    motion.from = 0;
    motion.to = 360;
    motion.course = Course::turn;
    for (const SceneNumber &number : numbers_of(session.document.scene)) {
        if (motion.mover == Mover::number && number.path == motion.path) {
            const Slider &slider = number.range.slider;
            motion.from = number.value;
            const double far = slider.logarithmic ? std::min(slider.high, 8 * number.value) : slider.high;
            motion.to = number.value < far ? far : slider.low;
            motion.course = Course::to_and_fro;
        }
    }
    session.playback.motion = std::move(motion);
}

} // namespace sandbox
