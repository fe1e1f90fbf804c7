#include "core/protocol/command.h"

#include "core/base/sealed_definitions.h"

namespace usar::protocol {

bool isDrive(const Command& command) {
    return std::visit(
        []<class T>(const T&) {
            if constexpr (requires { T::word; })
                return T::word.drives;
            else
                return false;
        },
        command);
}

} // namespace usar::protocol

template class usar::Sealed<usar::protocol::CommandVariant>;
