#include "core/mission/fleet/equipment_questions.h"

#include "core/base/alternatives.h"

namespace usar::mission {

void EquipmentQuestions::take(const protocol::InfoLine& line, Seconds now) {
    geometry_.take(line);
    configuration_.take(line);
    if (!first_heard_ || now < *first_heard_)
        first_heard_ = now;
    // The robot first: a UDK server names it as the mount of what is fixed to its base.
    std::visit(Overloaded{[this](const protocol::RobotState&) { wonder("Robot", true, true); },
                          [this](const protocol::SonarReadings&) { wonder("Sonar", true, true); },
                          [this](const protocol::RangeScan& scan) { wonder(scan.type, true, true); },
                          [this](const protocol::RangeReadings& rays) { wonder(rays.type, true, true); },
                          [this](const protocol::EncoderReadings&) { wonder("Encoder", false, true); },
                          [this](const protocol::PackageState&) { wonder("MisPkg", false, true); }, [](const auto&) {}},
               line.message);
}

void EquipmentQuestions::wonder(const std::string& type, bool where, bool what) {
    if (!wondered_.insert(type).second)
        return;
    if (where)
        geometry_.query(type);
    if (what)
        configuration_.query(type);
}

std::vector<protocol::Command> EquipmentQuestions::next(Seconds now) {
    std::vector<protocol::Command> questions;
    if (!first_heard_ || now - *first_heard_ <= patience || !wondered_.contains("Robot"))
        return questions;
    for (auto& question : {geometry_.next(now), configuration_.next(now)})
        if (question)
            questions.push_back(*question);
    (void)geometry_.takeFailures(); // Instruments do with what is known.
    (void)configuration_.takeFailures();
    return questions;
}

} // namespace usar::mission
