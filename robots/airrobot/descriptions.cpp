#include "robots/airrobot/descriptions.h"

#include <set>

#include "robots/airrobot/outlook.h"
#include "robots/airrobot/survey_body.h"

namespace usar::airrobot {

extern const char survey_plan_text[]; // Contents of resources/plans/airrobot.lap

namespace {

/// How they compare in time, coverage and error is measured by the campaign survey_settings.json.
std::vector<agent::ParameterPreset> presets() {
    std::map<std::string, agent::ParameterValue> fast{{"scan_altitude_m", Settings::by_resolution},
                                                      {"lane_spacing_m", Settings::by_resolution},
                                                      {"scan_speed_m_s", Settings::by_resolution},
                                                      {"transit_speed_m_s", 2.0},
                                                      {"descent_speed_m_s", 0.8},
                                                      {"turn_rate_rad_s", radians(60.0)},
                                                      {"acceleration_m_s2", 1.5}};
    auto balanced = fast;
    fast["least_gain_m"] = 1000.0;
    balanced["least_gain_m"] = 0.72;
    return {{"as-in-the-thesis",
             "As in the thesis",
             "Lanes 9 m apart at 1 m/s, quadrant by quadrant, and none past what was hidden.",
             {{"scan_altitude_m", 6.0},
              {"lane_spacing_m", 9.0},
              {"scan_speed_m_s", 1.0},
              {"transit_speed_m_s", 1.6},
              {"turn_rate_rad_s", radians(34.0)},
              {"acceleration_m_s2", 0.8},
              {"quadrant_limit_m", 150.0},
              {"least_gain_m", 1000.0}}},
            {"fast", "Fast",
             "Few lanes at full speed: some ground stays hidden behind treetops. Meant for a corrected map.", fast},
            {"balanced", "Balanced",
             "Few lanes at full speed, and then more past what was hidden. Meant for a corrected map.", balanced},
            {"exact",
             "Exact",
             "Lanes close together at full speed, so that little is hidden and strips overlap widely. Meant for a "
             "corrected map.",
             {{"scan_altitude_m", 6.0}, {"lane_spacing_m", 9.0}, {"scan_speed_m_s", 2.0}, {"transit_speed_m_s", 2.0}}}};
}

/// The terrain survey of the thesis's chapter 4 as a state machine. Goes through launch checklist, INS reset (which
/// also gives the INS its rest before the start), take-off and lanes. Returns home for a charge, after each sortie or
/// quadrant, and at the end; resets the INS and recharges on the ground; then resumes where it stopped. In every tick
/// it checks, in the order of the thesis's drive collection: silent sensors, battery, stuck, sonars, goal.
class SurveyBehavior : public agent::Behavior {
public:
    explicit SurveyBehavior(agent::BehaviorContext context) : flight_(std::move(context)) {}

    void onInfo(const protocol::InfoLine& line, agent::CommandPort&) override { flight_.hear(line); }
    void tick(const agent::Tick& tick, agent::CommandPort& port) override {
        if (flight_.finished())
            return;
        flight_.perceive(tick, port);
        if (flight_.phase() == Phase::Launch)
            launch(tick, port);
        else if (flight_.sensorsSilent() && flight_.phase() != Phase::Ground)
            flight_.awaitSensors(port);
        else
            act(tick, port);
        port.publish(flight_.status());
        publishEnding(port);
    }

    void order(agent::Order order, agent::CommandPort& port) override {
        if (flight_.finished())
            return;
        flight_.order(order, port);
        publishEnding(port);
    }

    void setParameters(const agent::ParameterSet& parameters) override { flight_.setParameters(parameters); }
    protocol::Command safeCommand() const override { return flight_.craft().still(); }

private:
    void publishEnding(agent::CommandPort& port) const {
        if (flight_.ending())
            port.publish(*flight_.ending());
    }

    void launch(const agent::Tick& tick, agent::CommandPort& port) {
        if (flight_.checkLaunch(tick, port) != LaunchState::Ready)
            return;
        flight_.planSurvey(port);
        flight_.beginReset();
    }

    void act(const agent::Tick& tick, agent::CommandPort& port) {
        watchBattery(port);
        const Phase phase = flight_.phase();
        if (flight_.paused() && phase != Phase::Landing && phase != Phase::Ground)
            return flight_.holdPlace(port);
        switch (phase) {
        case Phase::TakeOff:
            if (flight_.climb(flight_.craft().settings.scan_altitude_m, port))
                flight_.beginWork();
            return;
        case Phase::ToLane:
        case Phase::Lane:
            return survey(port);
        case Phase::Home:
            return flyHome(port);
        case Phase::Landing:
            if (flight_.land(port))
                flight_.beginReset();
            return;
        case Phase::Ground:
            return onGround(tick, port);
        case Phase::Launch:
        case Phase::Finished:
            return;
        }
    }

    /// Sends the robot home if a battery runs low.
    void watchBattery(agent::CommandPort& port) {
        if (flight_.phase() == Phase::Ground || flight_.phase() == Phase::Landing)
            return;
        if (flight_.robotBatteryLow())
            flight_.obeyRobotBattery(port);
        if (flight_.phase() != Phase::ToLane && flight_.phase() != Phase::Lane)
            return;
        if (flight_.batteryMargin() > 0.0)
            return;
        if (flight_.resumedGoalReached())
            flight_.returnToCharge(port);
        else
            flight_.abortScan(port);
    }

    void survey(agent::CommandPort& port) {
        if (flight_.goalReached())
            flight_.nextGoal(port);
        if (!flight_.returning() && flight_.fly(port) == FlightState::Unreachable)
            flight_.skipGoal(port);
    }

    void flyHome(agent::CommandPort& port) {
        if (flight_.atBase())
            flight_.beginLanding();
        else if (flight_.fly(port) == FlightState::Unreachable)
            flight_.landHere(port);
    }

    void onGround(const agent::Tick& tick, agent::CommandPort& port) {
        if (!flight_.stepReset(tick, port))
            return;
        if (flight_.scanOver())
            return flight_.conclude(port);
        if (flight_.paused() || !flight_.charged())
            return;
        if (flight_.returning())
            flight_.recharge();
        flight_.setOut(port);
    }

    SurveyFlight flight_;
};

} // namespace

AirRobot::AirRobot() : ListedRobot("USARBot.AirRobot", "AirRobot", {"INS", "GroundTruth", "RangeScanner", "Sonar"}) {
    add<SurveyBehavior>({.id = "airrobot/cpp",
                         .name = "Terrain survey (C++)",
                         .help = "Maps the mission area in lanes. Keeps its height above the terrain, flies around and "
                                 "over obstacles, charges at its base and lands there at the end.",
                         .needs_area = true,
                         .parameters = Settings::parameters.specs(),
                         .presets = presets()});
    addPlanned<SurveyBody>("airrobot/posh", "Terrain survey (POSH)", {"airrobot.lap", survey_plan_text},
                           surveyPrimitives());
}

Result<agent::TaskPreview> AirRobot::preview(const std::string&, const agent::BehaviorContext& context) const {
    const Settings settings = Settings::parameters.settings(context.parameters).asAsked();
    const auto survey = Survey::make(context.task, settings);
    if (!survey)
        return tl::unexpected(survey.error());
    const mapping::CoveragePlan& plan = survey->plan();
    agent::TaskPreview preview;
    preview.path_in_map_m = survey->path_m(context.task.start_in_map.position_m.head<2>(), settings);
    preview.length_m = plan.lane_length_m + plan.transit_length_m;
    const Outlook outlook = outlookOf(*survey, context.task.start_in_map.position_m.head<2>(), settings);
    preview.duration = outlook.expected;
    preview.outlook = outlook.range;
    preview.summary = std::to_string(plan.lanes.size()) + (plan.lanes.size() == 1 ? " lane" : " lanes");
    std::set<int> parts;
    for (const mapping::Lane& lane : plan.lanes)
        parts.insert(lane.sortie);
    if (parts.size() > 1)
        preview.summary += " in " + std::to_string(parts.size()) + " parts";
    return preview;
}

} // namespace usar::airrobot
