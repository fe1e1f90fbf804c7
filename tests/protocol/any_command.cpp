#include "any_command.h"

#include <array>
#include <utility>

using namespace usar;
using namespace usar::protocol;

namespace {

struct Dice {
    Random& random;
    Dialect dialect;

    bool flip() { return random() % 2 == 0; }
    int whole() { return static_cast<int>(random() % 2000) - 1000; }
    double number() {
        switch (random() % 4) {
        case 0:
            return static_cast<double>(random() % 200) - 100.0;
        case 1:
            return uniform(random, -1, 1) * 1e-9;
        case 2:
            return uniform(random, -1e6, 1e6);
        default:
            return uniform(random, -5, 5);
        }
    }
    double speed(bool normalized) { return normalized ? uniform(random, -100, 100) : number(); }
    std::string word() {
        static const std::string letters = "abcXYZ019_.-+,;:\xe9()[]";
        std::string text(1 + random() % 12, 'a');
        for (char& c : text)
            c = letters[random() % letters.size()];
        return text;
    }
    Token token() { return Token::make(word()).value(); }
    Name name() { return flip() ? Name{} : Name::make(word()).value(); }
    Text text() {
        std::string words = flip() ? word() : std::string();
        for (std::uint64_t more = words.empty() ? 0 : random() % 3; more > 0; --more)
            words += (flip() ? " " : "  ") + word();
        return Text::make(words).value();
    }
    Vec3 vector() { return {number(), number(), number()}; }
    Pose pose() { return {vector(), uniform(random, -pi, pi), uniform(random, -pi, pi), uniform(random, -pi, pi)}; }
    Seconds seconds() { return Seconds{number()}; }
    std::variant<Pose, Token> start() {
        if (flip())
            return pose();
        return token();
    }
    template <class Value>
    Value oneOf(int count) {
        return static_cast<Value>(random() % static_cast<std::uint64_t>(count));
    }
    template <class Method>
    auto perhaps(Method method) -> std::optional<std::remove_cvref_t<decltype((this->*method)())>> {
        if (flip())
            return std::nullopt;
        return (this->*method)();
    }
    std::optional<double> perhapsSpeed(bool normalized) {
        return flip() ? std::nullopt : std::optional(speed(normalized));
    }
    std::optional<double> perhapsNumber() { return perhaps(&Dice::number); }
    DriveSwitches switches() { return {perhaps(&Dice::flip), perhaps(&Dice::flip)}; }
    template <class Make>
    auto several(std::size_t least, Make make) {
        std::vector<decltype(make())> made;
        for (std::size_t count = least + random() % 4; count > 0; --count)
            made.push_back(make());
        return made;
    }
};

template <class T>
struct Kind {};

Command any(Dice& dice, Kind<RawCommand>) {
    return RawCommand{"X" + dice.word() + " {" + dice.word() + "}"};
}
Command any(Dice& dice, Kind<Init>) {
    Init init{dice.token(), dice.name(), dice.start(), {}, dice.perhaps(&Dice::seconds)};
    if (std::holds_alternative<Token>(init.start))
        init.fallback_in_map = dice.perhaps(&Dice::pose);
    return init;
}
Command any(Dice& dice, Kind<AerialDrive>) {
    const bool normalized = dice.flip();
    return AerialDrive{dice.perhapsSpeed(normalized),
                       dice.perhapsSpeed(normalized),
                       dice.perhapsSpeed(normalized),
                       dice.perhapsSpeed(normalized),
                       normalized,
                       dice.perhapsNumber(),
                       dice.perhapsNumber(),
                       dice.switches()};
}
Command any(Dice& dice, Kind<SkidDrive>) {
    const bool normalized = dice.flip();
    return SkidDrive{dice.speed(normalized), dice.perhapsSpeed(normalized), normalized, dice.switches()};
}
Command any(Dice& dice, Kind<AckermannDrive>) {
    const bool normalized = dice.flip();
    if (dice.dialect == Dialect::Udk)
        return AckermannDrive{dice.speed(normalized), dice.number(), dice.number(), normalized, dice.switches()};
    return AckermannDrive{dice.perhapsSpeed(normalized), dice.number(), dice.perhapsNumber(), normalized,
                          dice.switches()};
}
Command any(Dice& dice, Kind<OmniDrive>) {
    const auto wheel = [&] { return WheelDrive{dice.whole(), dice.perhapsNumber(), dice.perhapsNumber()}; };
    return OmniDrive{dice.several(1, wheel), dice.flip(), dice.switches()};
}
Command any(Dice& dice, Kind<NauticDrive>) {
    const bool normalized = dice.flip();
    return NauticDrive{dice.perhapsSpeed(normalized), dice.number(), dice.perhapsNumber(), normalized, dice.switches()};
}
Command any(Dice& dice, Kind<JointDrive>) {
    return JointDrive{dice.token(),         dice.oneOf<JointOrder>(7),
                      dice.perhapsNumber(), dice.perhapsNumber(),
                      dice.flip(),          dice.switches()};
}
Command any(Dice& dice, Kind<MultiDrive>) {
    return MultiDrive{dice.several(0, [&] { return JointAngleTarget{dice.token(), dice.number()}; })};
}
Command any(Dice& dice, Kind<DriveSwitches>) {
    return dice.switches();
}
template <class Question>
Command question(Dice& dice) {
    if (dice.flip())
        return Question{dice.token(), dice.name()};
    return Question{dice.flip() ? Token("Robot") : packageType(dice.dialect), dice.name()};
}
Command any(Dice& dice, Kind<GetGeometry>) {
    return question<GetGeometry>(dice);
}
Command any(Dice& dice, Kind<GetConfiguration>) {
    return question<GetConfiguration>(dice);
}
Command any(Dice& dice, Kind<SetInsPose>) {
    return SetInsPose{dice.name(), dice.pose()};
}
Command any(Dice& dice, Kind<ResetSensor>) {
    return ResetSensor{dice.flip() ? Token("Odometry") : dice.token(), dice.name()};
}
Command any(Dice& dice, Kind<ScanNow>) {
    return ScanNow{dice.flip() ? Token("RangeScanner") : dice.token(), dice.name()};
}
Command any(Dice& dice, Kind<ReadTag>) {
    return ReadTag{dice.token(), dice.name()};
}
Command any(Dice& dice, Kind<WriteTag>) {
    return WriteTag{dice.token(), dice.text(), dice.name()};
}
Command any(Dice& dice, Kind<ReleaseTag>) {
    return ReleaseTag{dice.name()};
}
Command any(Dice& dice, Kind<CountTags>) {
    return CountTags{dice.name()};
}
Command any(Dice& dice, Kind<UseGripper>) {
    return UseGripper{dice.oneOf<GripperAction>(4), dice.name()};
}
Command any(Dice& dice, Kind<UseToolChanger>) {
    return UseToolChanger{dice.flip(), dice.name()};
}
Command any(Dice& dice, Kind<SetItem>) {
    return SetItem{dice.token(), dice.token(), dice.name(), dice.text()};
}
Command any(Dice& dice, Kind<SetJoint>) {
    return SetJoint{dice.token(), dice.oneOf<JointOpcode>(7), dice.number(), dice.perhapsNumber()};
}
Command any(Dice& dice, Kind<ZoomCamera>) {
    return ZoomCamera{dice.number(), dice.name()};
}
Command any(Dice& dice, Kind<AttachCamera>) {
    return AttachCamera{dice.token(), dice.token(), dice.name()};
}
Command any(Dice& dice, Kind<DetachCamera>) {
    return DetachCamera{dice.token()};
}
Command any(Dice& dice, Kind<SetViewports>) {
    return SetViewports{dice.oneOf<ViewLayout>(2), {dice.name(), "Disabled", "None", dice.name()}};
}
Command any(Dice& dice, Kind<PackageDrive>) {
    const auto target = [&] { return LinkTarget{dice.whole(), dice.number(), dice.oneOf<LinkOrder>(3)}; };
    return PackageDrive{dice.token(), dice.several(0, target), dice.perhaps(&Dice::whole), dice.perhaps(&Dice::flip)};
}
Command any(Dice& dice, Kind<PackageRotation>) {
    return PackageRotation{dice.token(), dice.number(), dice.number(), dice.oneOf<LinkOrder>(3)};
}
Command any(Dice& dice, Kind<ActuatorDrive>) {
    const auto target = [&] { return LinkValue{dice.whole(), dice.number()}; };
    return ActuatorDrive{dice.token(), dice.several(0, target), dice.perhaps(&Dice::flip), dice.perhaps(&Dice::whole)};
}
Command any(Dice& dice, Kind<Trace>) {
    const auto color = dice.oneOf<TraceColor>(7);
    return Trace{dice.flip(), dice.perhaps(&Dice::seconds), dice.flip() ? std::optional(color) : std::nullopt};
}
Command any(Dice& dice, Kind<CreateObject>) {
    const auto physics = dice.oneOf<ObjectPhysics>(2);
    return CreateObject{dice.token(),
                        dice.name(),
                        dice.start(),
                        dice.perhaps(&Dice::vector),
                        dice.flip() ? std::optional(physics) : std::nullopt,
                        dice.perhaps(&Dice::flip),
                        dice.text(),
                        dice.name()};
}
Command any(Dice& dice, Kind<KillObject>) {
    return KillObject{dice.token()};
}
Command any(Dice& dice, Kind<KillAllObjects>) {
    if (dice.flip())
        return KillAllObjects{};
    return KillAllObjects{Box{dice.vector(), dice.vector()}};
}
Command any(Dice& dice, Kind<PlaceObject>) {
    return PlaceObject{dice.token(), dice.pose()};
}
Command any(Dice& dice, Kind<ShiftObject>) {
    return ShiftObject{dice.token(), dice.pose()};
}
Command any(Dice& dice, Kind<SpinObject>) {
    return SpinObject{dice.token(), dice.vector()};
}
Command any(Dice& dice, Kind<RunConveyor>) {
    return RunConveyor{dice.token(), dice.number()};
}
Command any(Dice& dice, Kind<AddWaypoints>) {
    return AddWaypoints{dice.token(), dice.several(0, [&] { return dice.vector(); })};
}
Command any(Dice& dice, Kind<ClearWaypoints>) {
    return ClearWaypoints{dice.token()};
}
Command any(Dice& dice, Kind<FollowWaypoints>) {
    FollowWaypoints follow{
        dice.token(), {}, dice.perhaps(&Dice::flip), dice.perhaps(&Dice::flip), dice.perhaps(&Dice::flip)};
    if (dice.flip())
        follow.pace = WaypointSpeed{dice.number()};
    else
        follow.pace = dice.seconds();
    return follow;
}
Command any(Dice& dice, Kind<GetObjectStates>) {
    return GetObjectStates{dice.name(), dice.name()};
}
Command any(Dice& dice, Kind<GetClosestPathNode>) {
    return GetClosestPathNode{dice.vector()};
}
Command any(Dice& dice, Kind<GoToNode>) {
    return GoToNode{dice.token()};
}
Command any(Dice& dice, Kind<WalkTo>) {
    WalkTo walk{Vec2(dice.number(), dice.number()), dice.oneOf<Gait>(3), dice.flip()};
    if (dice.flip())
        walk.goal = dice.token();
    return walk;
}
Command any(Dice& dice, Kind<Lockstep>) {
    return Lockstep{dice.flip()};
}
Command any(Dice& dice, Kind<Pause>) {
    return Pause{dice.seconds()};
}
/// What has nothing to choose.
template <class T>
Command any(Dice&, Kind<T>) {
    static_assert(std::is_empty_v<T>);
    return T{};
}

template <std::size_t... kind>
constexpr auto makersOf(std::index_sequence<kind...>) {
    using Make = Command (*)(Dice&);
    return std::array<Make, sizeof...(kind)>{
        [](Dice& dice) { return any(dice, Kind<std::variant_alternative_t<kind, CommandVariant>>{}); }...};
}

} // namespace

namespace any {

Command command(std::size_t kind, Dialect dialect, Random& random) {
    static constexpr auto makers = makersOf(std::make_index_sequence<kinds>());
    Dice dice{random, dialect};
    return makers[kind](dice);
}

} // namespace any
