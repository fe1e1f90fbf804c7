#include "core/base/cause.h"

#include <utility>

namespace usar::by {

namespace {

constexpr std::string_view hand_prefix = "by hand: ";
constexpr std::string_view session_prefix = "session: ";
constexpr std::string_view operator_prefix = "operator: ";
constexpr std::string_view colon = ": ";
constexpr std::string_view path_separator = " ▸ ";

/// Leaves out the colon with an empty id, but not with an empty decision.
std::string withId(const std::string& behavior_id, const std::string& decision) {
    return behavior_id.empty() ? decision : behavior_id + std::string(colon) + decision;
}

struct TextOf {
    std::string operator()(const Other& other) const { return other.name; }
    std::string operator()(const Behavior& behavior) const { return withId(behavior.behavior_id, behavior.state); }
    std::string operator()(const Plan& plan) const {
        return withId(plan.behavior_id, plan.why.empty() ? plan.path : plan.path + std::string(colon) + plan.why);
    }
    std::string operator()(const Hand& hand) const { return std::string(hand_prefix) + hand.what; }
    std::string operator()(const Session& session) const { return std::string(session_prefix) + session.why; }
    std::string operator()(const Operator& user) const { return std::string(operator_prefix) + user.what; }
};

/// Reads "state" or "path: why", without the behavior's id before it.
Source readDecision(std::string behavior_id, std::string_view decision) {
    const std::size_t path_end = decision.find(colon);
    const std::string_view path = decision.substr(0, path_end);
    if (path.find(path_separator) == std::string_view::npos)
        return Behavior{std::move(behavior_id), std::string(decision)};
    if (path_end == std::string_view::npos)
        return Plan{std::move(behavior_id), std::string(path), {}};
    const std::string_view why = decision.substr(path_end + colon.size());
    return Plan{std::move(behavior_id), std::string(why.empty() ? decision : path), std::string(why)};
}

} // namespace

std::string toText(const Source& source) {
    return std::visit(TextOf{}, source);
}

Source readSource(std::string_view text) {
    const auto after = [text](std::string_view prefix) { return std::string(text.substr(prefix.size())); };
    if (text.starts_with(hand_prefix))
        return Hand{after(hand_prefix)};
    if (text.starts_with(session_prefix))
        return Session{after(session_prefix)};
    if (text.starts_with(operator_prefix))
        return Operator{after(operator_prefix)};
    const std::size_t id_end = text.find(colon);
    if (id_end == 0 || id_end == std::string_view::npos)
        return Other{std::string(text)};
    return readDecision(std::string(text.substr(0, id_end)), text.substr(id_end + colon.size()));
}

} // namespace usar::by
