#include "core/mission/session/stream_name.h"

#include "core/base/text.h"

namespace usar::mission {

namespace {

struct Namer {
    std::string operator()(const protocol::GenericMessage& message) const {
        return message.type.empty() ? message.type_word : message.type_word + ' ' + message.type;
    }
    std::string operator()(const protocol::GameInfo&) const { return "NFO"; }
    std::string operator()(const protocol::StartPoses&) const { return "NFO StartPoses"; }
    std::string operator()(const protocol::LockstepInfo&) const { return "NFO Lockstep"; }
    std::string operator()(const protocol::RobotState&) const { return "STA"; }
    std::string operator()(const protocol::PathNodes&) const { return "NFO PathNodes"; }
    std::string operator()(const protocol::ClosestPathNode&) const { return "NFO Pathnode"; }
    std::string operator()(const protocol::PackageState&) const { return "MISSTA"; }
    std::string operator()(const protocol::EffecterState&) const { return "EFF"; }
    std::string operator()(const protocol::WorldObjects&) const { return "STA"; }
    template <protocol::SensorMessage Sensor>
    std::string operator()(const Sensor& sensor) const {
        const std::string_view type = protocol::wireTypeOf(sensor);
        return type.empty() ? "SEN" : "SEN " + std::string(type);
    }
    std::string operator()(const protocol::GeometryInfo&) const { return "GEO"; }
    std::string operator()(const protocol::ConfigurationInfo&) const { return "CONF"; }
    std::string operator()(const protocol::Response&) const { return "RES"; }
};

} // namespace

std::string streamName(const protocol::InfoMessage& message) {
    return std::visit(Namer{}, message);
}

bool isRobotData(const protocol::InfoMessage& message) {
    return std::visit(
        []<class Message>(const Message& one) {
            if constexpr (std::is_same_v<Message, protocol::GenericMessage>)
                return sameWord(one.type_word, "SEN") || sameWord(one.type_word, "STA");
            else
                return protocol::SensorMessage<Message> || std::is_same_v<Message, protocol::RobotState>;
        },
        message);
}

} // namespace usar::mission
