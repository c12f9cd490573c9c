#pragma once

#include "scene/motion.h"

namespace sandbox {

/// A motion being played over the document, which it never changes: undo knows nothing of it.
struct Playback {
    Motion motion;
    bool shown = false;   ///< the views show a moment of it; else the scene itself
    bool playing = false; ///< moment follows moment
    int moment = 0;
};

struct Session;
struct Document;

/// The document as the views show it: with its scene as the motion has it at this moment.
Document shown_document(const Session &session);
/// Plays, or pauses where it is. A motion that the scene has not becomes the status line's error.
void play_or_pause(Session &session);
/// Pauses, then goes by so many moments.
void step_motion(Session &session, int moments);
/// While it plays: goes on by one moment, or stops with an error where the scene has lost what moves.
void next_moment(Session &session);
/// Shows the scene itself again.
void stop_motion(Session &session);
/// Makes what the views show the scene, as one step that can be undone, and stops.
void keep_moment(Session &session);
/// Something else moves: from how it is, once around or to the end of its slider and back; paused at its first moment.
void choose_motion(Session &session, Motion motion);

} // namespace sandbox
