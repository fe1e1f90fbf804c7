#include "core/protocol/command.h"

namespace usar::protocol {

namespace {

template <class T, class... Kinds>
constexpr bool is_one_of = (std::is_same_v<T, Kinds> || ...);

} // namespace

Command::Command() = default;
Command::Command(const Command& other) = default;
Command::Command(Command&& other) noexcept = default;
Command& Command::operator=(const Command& other) = default;
Command& Command::operator=(Command&& other) noexcept = default;
Command::~Command() = default;

bool Command::operator==(const Command& other) const {
    return static_cast<const CommandVariant&>(*this) == static_cast<const CommandVariant&>(other);
}

bool isDrive(const Command& command) {
    return std::visit(
        []<class T>(const T&) {
            return is_one_of<T, SkidDrive, AckermannDrive, OmniDrive, AerialDrive, NauticDrive, JointDrive, MultiDrive,
                             DriveSwitches>;
        },
        command);
}

} // namespace usar::protocol
