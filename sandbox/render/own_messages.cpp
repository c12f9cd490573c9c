#include "render/own_messages.h"

#include <glm/vec4.hpp>

namespace sandbox {
namespace {

constexpr std::uint64_t longest_text = 1U << 26; ///< bytes; neither side believes in more

template <typename Value> bool send_value(const Socket &socket, const Value &value, double deadline) {
    return socket.send(&value, sizeof value, deadline);
}
template <typename Value> bool receive_value(const Socket &socket, Value &value, double deadline) {
    return socket.receive(&value, sizeof value, deadline);
}

bool send_text(const Socket &socket, const std::string &text, double deadline) {
    return send_value(socket, std::uint64_t{text.size()}, deadline) && socket.send(text.data(), text.size(), deadline);
}
bool receive_text(const Socket &socket, std::string &text, double deadline) {
    std::uint64_t length = 0;
    if (!receive_value(socket, length, deadline) || length > longest_text) {
        return false;
    }
    text.resize(length);
    return socket.receive(text.data(), length, deadline);
}

template <typename Item> bool send_items(const Socket &socket, const std::vector<Item> &items, double deadline) {
    return socket.send(items.data(), items.size() * sizeof(Item), deadline);
}
template <typename Item> bool receive_items(const Socket &socket, std::vector<Item> &items, double deadline) {
    return socket.receive(items.data(), items.size() * sizeof(Item), deadline);
}

} // namespace

bool send_request(const Socket &socket, const OwnRequest &request, double deadline) {
    return send_text(socket, request.scene, deadline) && send_text(socket, request.technique, deadline) &&
           send_text(socket, request.file, deadline) && send_text(socket, request.text, deadline) &&
           send_value(socket, request.picture_shift, deadline) && send_value(socket, request.size, deadline) &&
           send_value(socket, request.object_ids, deadline) && send_value(socket, request.processor_seconds, deadline);
}

std::optional<OwnRequest> receive_request(const Socket &socket, double deadline) {
    OwnRequest request;
    const bool whole =
        receive_text(socket, request.scene, deadline) && receive_text(socket, request.technique, deadline) &&
        receive_text(socket, request.file, deadline) && receive_text(socket, request.text, deadline) &&
        receive_value(socket, request.picture_shift, deadline) && receive_value(socket, request.size, deadline) &&
        receive_value(socket, request.object_ids, deadline) &&
        receive_value(socket, request.processor_seconds, deadline);
    return whole ? std::optional(std::move(request)) : std::nullopt;
}

bool send_response(const Socket &socket, const OwnResponse &response, double deadline) {
    return send_value(socket, response.outcome, deadline) && send_value(socket, response.processor_seconds, deadline) &&
           (response.outcome == OwnResponse::Outcome::picture
                ? send_value(socket, response.frame.milliseconds, deadline) &&
                      send_items(socket, response.frame.color.pixels, deadline) &&
                      send_items(socket, response.frame.object_ids, deadline)
                : send_text(socket, response.message, deadline));
}

std::optional<OwnResponse> receive_response(const Socket &socket, Size size, bool object_ids, double deadline) {
    OwnResponse response;
    if (!receive_value(socket, response.outcome, deadline) ||
        !receive_value(socket, response.processor_seconds, deadline)) {
        return std::nullopt;
    }
    if (response.outcome != OwnResponse::Outcome::picture) {
        return receive_text(socket, response.message, deadline) ? std::optional(std::move(response)) : std::nullopt;
    }
    Frame &frame = response.frame;
    frame.color = Image(size);
    frame.object_ids.resize(object_ids ? frame.color.pixels.size() : 0);
    const bool whole = receive_value(socket, frame.milliseconds, deadline) &&
                       receive_items(socket, frame.color.pixels, deadline) &&
                       receive_items(socket, frame.object_ids, deadline);
    return whole ? std::optional(std::move(response)) : std::nullopt;
}

} // namespace sandbox
