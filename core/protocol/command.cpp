#include "core/protocol/command.h"

#include "core/base/sealed_definitions.h"

namespace usar::protocol {

namespace {

template <class T, class... Kinds>
constexpr bool is_one_of = (std::is_same_v<T, Kinds> || ...);

} // namespace

bool isDrive(const Command& command) {
    return std::visit(
        []<class T>(const T&) {
            return is_one_of<T, SkidDrive, AckermannDrive, OmniDrive, AerialDrive, NauticDrive, JointDrive, MultiDrive,
                             DriveSwitches>;
        },
        command);
}

} // namespace usar::protocol

template class usar::Sealed<usar::protocol::CommandVariant>;
