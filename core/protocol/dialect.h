// The two dialects of the protocol. Readers of info lines accept both at once; writers use the one they are given.
#pragma once

namespace usar::protocol {

/// USARSim for Unreal Tournament 2004, and USARSim for the Unreal Development Kit.
enum class Dialect { Ut2004, Udk };

} // namespace usar::protocol
