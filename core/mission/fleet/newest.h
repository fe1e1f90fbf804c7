// Finds the newest value of a type in an update of a session.
#pragma once

#include <variant>

#include "core/mission/session/session_update.h"

namespace usar::mission {

/// Returns the newest message of a type in this update, or nullptr.
template <class Message>
const Message* newest(const mission::SessionUpdate& update) {
    for (auto line = update.lines.rbegin(); line != update.lines.rend(); ++line)
        if (const auto* message = std::get_if<Message>(&line->message))
            return message;
    return nullptr;
}

/// Returns the newest value of a type that the behavior published in this update, or nullptr.
template <class Value>
const Value* newestPublished(const mission::SessionUpdate& update) {
    for (auto value = update.published.rbegin(); value != update.published.rend(); ++value)
        if (const auto* found = std::get_if<Value>(&*value))
            return found;
    return nullptr;
}

} // namespace usar::mission
