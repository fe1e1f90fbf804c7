// Random commands of every kind, for tests of rules that hold for all of them.
#pragma once

#include "core/base/random.h"
#include "core/protocol/command.h"
#include "core/protocol/dialect.h"

namespace any {

inline constexpr std::size_t kinds = std::variant_size_v<usar::protocol::CommandVariant>;

/// A random command of this alternative of Command, which has a meaning in that dialect. A RawCommand has a word that
/// no reader knows.
usar::protocol::Command command(std::size_t kind, usar::protocol::Dialect dialect, usar::Random& random);

} // namespace any
