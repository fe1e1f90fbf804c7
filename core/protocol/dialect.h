// The two families of servers; a client reads both at once and writes what it is told to.
#pragma once

namespace usar::protocol {

enum class Dialect { Ut2004, Udk };

} // namespace usar::protocol
