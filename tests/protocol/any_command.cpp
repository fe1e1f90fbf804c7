#include "any_command.h"

#include <array>
#include <utility>

#include "core/protocol/commands/command_kinds.h"

using namespace usar;
using namespace usar::protocol;

namespace {

/// Fills a command with random values: a visitor of T::segments, like LineIn.
class Dice {
public:
    static constexpr bool reading = true;
    static constexpr bool writing = false;

    Dice(Random& random, Dialect dialect) : random_(random), dialect_(dialect) {}
    Dialect dialect() const { return dialect_; }

    auto oneOf(const auto& all) -> decltype(all[0]) { return all[random_() % all.size()]; }

    void mark(const Key&, std::string_view, std::string_view = {}) {}
    template <class Value, std::size_t count>
    void mark(const Key&, Value& value, const std::array<WireWord<Value>, count>& table) {
        value = oneOf(table).value;
    }
    void ignored(const Key&) {}
    void number(const Key&, double& value, NumberForm form = {}) {
        value = form.scaled && normalized_ ? uniform(random_, -100, 100) : anyNumber();
    }
    void number(const Key&, int& value, NumberForm = {}) { value = static_cast<int>(random_() % 2000) - 1000; }
    void number(const Key&, Seconds& value, NumberForm = {}) { value = Seconds{anyNumber()}; }
    /// The first speed is always there, so that the line tells what kind of DRIVE it is.
    template <class Value>
    void number(const Key& key, std::optional<Value>& value, NumberForm form = {}) {
        if (form.or_zero || (form.scaled && std::exchange(first_, false)) || flip())
            number(key, value.emplace(), form);
    }
    void beginScale(bool& normalized) { normalized = normalized_ = flip(); }
    void endScale() {}
    void flag(const Key&, bool& value) { value = flip(); }
    void flag(const Key&, std::optional<bool>& value) {
        if (flip())
            value = flip();
    }
    void neededFlag(const Key& key, bool& value) { flag(key, value); }
    void digit(const Key& key, std::optional<bool>& value) { flag(key, value); }
    void text(const Key& key, Token& value) {
        value = key.words.empty() || flip() ? token() : tokenOf(oneOf(key.words));
    }
    void text(const Key&, Name& value) { value = flip() ? Name{} : Name::make(word()).value(); }
    void text(const Key&, Text& value) {
        std::string words = flip() ? word() : std::string();
        for (std::uint64_t more = words.empty() ? 0 : random_() % 3; more > 0; --more)
            words += (flip() ? " " : "  ") + word();
        value = Text::make(words).value();
    }
    template <class Value>
    void choice(const Key&, Value& value) {
        value = oneOf(wire_words<Value>).value;
    }
    template <class Value>
    void choice(const Key& key, std::optional<Value>& value) {
        if (flip())
            choice(key, value.emplace());
    }
    void vector(const Key&, Vec3& value) { value = anyVector(); }
    void vector(const Key&, std::optional<Vec3>& value) {
        if (flip())
            value = anyVector();
    }
    void position(const Key&, Vec3& value) { value = anyVector(); }
    void position(const Key& key, std::optional<Vec3>& value) { vector(key, value); }
    void pose(Pose& pose) {
        const auto angle = [this] { return uniform(random_, -pi, pi); };
        pose = {anyVector(), angle(), angle(), angle()};
    }
    void start(const Key&, std::variant<Pose, Token>& start, std::optional<Pose>* fallback = nullptr) {
        if (flip())
            return pose(start.emplace<Pose>());
        start = token();
        if (fallback && flip())
            pose(fallback->emplace());
    }
    void sixNumbers(const Key&, Pose& value) { pose(value); }
    void goal(const Key&, const Key&, std::variant<Vec2, Token>& goal) {
        goal = Vec2(anyNumber(), anyNumber());
        if (flip())
            goal = token();
    }
    void points(const Key&, std::vector<Vec3>& points) {
        for (std::size_t count = random_() % 4; count > 0; --count)
            points.push_back(anyVector());
    }
    void box(const Key&, const Key&, std::optional<Box>& box) {
        if (flip())
            box = Box{anyVector(), anyVector()};
    }
    void pace(const Key&, const Key&, std::variant<WaypointSpeed, Seconds>& pace) {
        if (flip())
            pace = WaypointSpeed{anyNumber()};
        else
            pace = Seconds{anyNumber()};
    }
    void valueAndSteer(const Key&, double& value, std::optional<double>& steer_rad) {
        value = anyNumber();
        if (flip())
            steer_rad = anyNumber();
    }
    void tagAndText(const Key& key, Token& tag, Text& memory) {
        tag = token();
        text(key, memory);
    }
    template <class Element>
    void groups(const Key&, std::vector<Element>& elements) {
        for (std::size_t count = 1 + random_() % 4; count > 0; --count)
            Element::segments(*this, elements.emplace_back());
    }
    template <class Target>
    void joints(std::span<const Key>, std::vector<Target>& targets) {
        for (std::size_t count = random_() % 4; count > 0; --count)
            targets.push_back({token(), anyNumber()});
    }

    std::string word() {
        static const std::string letters = "abcXYZ019_.-+,;:\xe9()[]";
        std::string text(1 + random_() % 12, 'a');
        for (char& c : text)
            c = letters[random_() % letters.size()];
        return text;
    }

private:
    bool flip() { return random_() % 2 == 0; }
    double anyNumber() {
        switch (random_() % 4) {
        case 0:
            return static_cast<double>(random_() % 200) - 100.0;
        case 1:
            return uniform(random_, -1, 1) * 1e-9;
        case 2:
            return uniform(random_, -1e6, 1e6);
        default:
            return uniform(random_, -5, 5);
        }
    }
    Vec3 anyVector() { return {anyNumber(), anyNumber(), anyNumber()}; }
    static Token tokenOf(std::string_view text) { return Token::make(text).value(); }
    Token token() { return tokenOf(word()); }

    Random& random_;
    Dialect dialect_;
    bool normalized_ = false;
    bool first_ = true;
};

template <class T>
Command any(Random& random, Dialect dialect) {
    Dice dice(random, dialect);
    if constexpr (std::is_same_v<T, RawCommand>) {
        return RawCommand{"X" + dice.word() + " {" + dice.word() + "}"};
    } else {
        T command = blank<T>();
        T::segments(dice, command);
        return command;
    }
}

template <std::size_t... kind>
constexpr auto makersOf(std::index_sequence<kind...>) {
    using Make = Command (*)(Random&, Dialect);
    return std::array<Make, sizeof...(kind)>{any<std::variant_alternative_t<kind, CommandVariant>>...};
}

} // namespace

namespace any {

Command command(std::size_t kind, Dialect dialect, Random& random) {
    static constexpr auto makers = makersOf(std::make_index_sequence<kinds>());
    return makers[kind](random, dialect);
}

} // namespace any
