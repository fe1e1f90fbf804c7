#include "core/mission/stream_name.h"

#include "core/protocol/segments.h"

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
    std::string operator()(const protocol::SonarReadings&) const { return "SEN Sonar"; }
    std::string operator()(const protocol::RangeScan& scan) const {
        return scan.type.empty() ? "SEN" : "SEN " + scan.type;
    }
    std::string operator()(const protocol::InsReading&) const { return "SEN INS"; }
    std::string operator()(const protocol::GroundTruthReading&) const { return "SEN GroundTruth"; }
    std::string operator()(const protocol::OdometryReading&) const { return "SEN Odometry"; }
    std::string operator()(const protocol::EncoderReadings&) const { return "SEN Encoder"; }
    std::string operator()(const protocol::GeometryInfo&) const { return "GEO"; }
    std::string operator()(const protocol::ConfigurationInfo&) const { return "CONF"; }
    std::string operator()(const protocol::Response&) const { return "RES"; }
};

} // namespace

std::string streamName(const protocol::InfoMessage& message) {
    return std::visit(Namer{}, message);
}

bool isRobotData(const protocol::InfoMessage& message) {
    if (const auto* generic = std::get_if<protocol::GenericMessage>(&message))
        return protocol::sameWord(generic->type_word, "SEN") || protocol::sameWord(generic->type_word, "STA");
    return std::holds_alternative<protocol::RobotState>(message) ||
           std::holds_alternative<protocol::SonarReadings>(message) ||
           std::holds_alternative<protocol::RangeScan>(message) ||
           std::holds_alternative<protocol::InsReading>(message) ||
           std::holds_alternative<protocol::GroundTruthReading>(message) ||
           std::holds_alternative<protocol::OdometryReading>(message) ||
           std::holds_alternative<protocol::EncoderReadings>(message);
}

} // namespace usar::mission
