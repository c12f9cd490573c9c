#pragma once

#include "image/image.h"
#include "render/socket.h"

#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>

/// What OwnProcess and its server say to each other. Both are the same executable on the same machine, so numbers
/// travel as they stand in memory.
namespace sandbox {

struct OwnRequest {
    std::string scene, technique; ///< as files and commands have them
    std::string file, text;       ///< of own shading
    glm::dvec2 picture_shift{0};  ///< the camera's: no scene file has it
    Size size;
    bool object_ids = false;
    int processor_seconds = 0; ///< that the server may use for it
};

struct OwnResponse {
    enum class Outcome : std::uint32_t { picture, input_error, machine_error };
    Outcome outcome = Outcome::picture;
    Frame frame;
    std::string message;          ///< of an error
    double processor_seconds = 0; ///< used by the server since it began
};

/// False, or nothing, where the other end is closed or the deadline comes first.
bool send_request(const Socket &socket, const OwnRequest &request, double deadline);
std::optional<OwnRequest> receive_request(const Socket &socket, double deadline);
bool send_response(const Socket &socket, const OwnResponse &response, double deadline);
/// A picture must be of that size.
std::optional<OwnResponse> receive_response(const Socket &socket, Size size, bool object_ids, double deadline);

} // namespace sandbox
