// This test compares what both profiles send, word by word, with lines that real servers sent: keys, order, spaces,
// decimals, ranges.
#include <QObject>
#include <QString>
#include <QTest>

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <limits>
#include <map>
#include <set>

#include "core/base/numbers.h"
#include "tests/protocol/corpus.h"
#include "tests/sim/talker.h"
#include "tests/sim/tiny_worlds.h"
#include "tests/suite/suite.h"

namespace tst_wire_as_captured {

using namespace usar;
using namespace usar::sim;

namespace {

bool isMark(char c) {
    return c == ' ' || c == '{' || c == '}' || c == ',';
}

/// "CONF Camera": configurations and geometries by what they are of, too.
std::string exactKindOf(const std::string& line) {
    const std::string kind = kindOf(line);
    const std::size_t type = line.find("{Type ");
    if ((kind != "CONF" && kind != "GEO") || type == std::string::npos)
        return kind;
    return kind + " " + line.substr(type + 6, line.find('}', type) - type - 6);
}

/// Words, and each brace, comma and space by itself.
std::vector<std::string> tokensOf(const std::string& line) {
    std::vector<std::string> tokens;
    bool in_word = false;
    for (const char c : line) {
        if (c == '\r' || c == '\n')
            continue;
        if (isMark(c) || !in_word)
            tokens.emplace_back();
        tokens.back() += c;
        in_word = !isMark(c);
    }
    return tokens;
}

/// The number of decimals of a number; nothing for a word.
std::optional<int> decimalsOf(const std::string& token) {
    if (!readNumber(token) || std::isalpha(static_cast<unsigned char>(token.front())))
        return std::nullopt;
    const std::size_t point = token.find('.');
    return point == std::string::npos ? 0 : static_cast<int>(token.size() - point) - 1;
}

/// Decimals and range of one field in all lines of a kind.
struct Field {
    std::set<int> decimals;
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();

    QString text() const {
        QString all;
        for (const int one : decimals)
            all += QString(all.isEmpty() ? "%1" : " or %1").arg(one);
        return QString("%1 decimals, %2 to %3").arg(all).arg(least).arg(most);
    }
};

/// The fields and shapes of lines, by their kind ("SEN Sonar").
struct Wire {
    std::map<std::string, std::map<std::string, Field>> fields;
    std::map<std::string, std::set<std::string>> shapes;

    void read(const std::string& line);
};

/// A shape's repeated values ("#4,#4,#4") and repeated groups ("{Name * Range #4} {Name * Range #4}") count once.
std::string withoutRepetitions(std::string shape) {
    const auto collapse = [&shape](const std::string& piece, const std::string& between) {
        const std::string twice = piece + between + piece;
        for (std::size_t at = shape.find(twice); at != std::string::npos; at = shape.find(twice, at))
            shape.erase(at, piece.size() + between.size());
    };
    for (const char* decimals : {"#0", "#2", "#3", "#4"})
        collapse(decimals, ",");
    collapse("{PartName *} {Location #2}", " ");
    collapse("{Link #0} {Value #4}", " ");
    collapse("{Link #0} {Value #4} {Torque #2}", " ");
    for (std::size_t at = shape.find('{'); at != std::string::npos; at = shape.find('{', at + 1)) {
        const std::size_t end = shape.find('}', at);
        if (end != std::string::npos)
            collapse(shape.substr(at, end - at + 1), " ");
    }
    return shape;
}

void Wire::read(const std::string& line) {
    const std::string kind = exactKindOf(line);
    std::string shape;
    std::string word; // the key that the values after it belong to
    int nth = 0;
    bool after_name = false;
    for (const std::string& token : tokensOf(line)) {
        const auto decimals = decimalsOf(token);
        if (token == ",")
            ++nth;
        if (isMark(token.front())) {
            shape += token;
            continue;
        }
        if (!decimals || after_name) {
            shape += after_name ? "*" : token;
            after_name = !after_name && (token == "Name" || token == "Level" || token == "Mount" || token == "Status" ||
                                         token == "PartName");
            word = after_name ? word : token;
            nth = 0;
            continue;
        }
        shape += '#' + std::to_string(*decimals);
        Field& field = fields[kind][word + (nth > 0 ? "+" : "")];
        field.decimals.insert(*decimals);
        field.least = std::min(field.least, *readNumber(token));
        field.most = std::max(field.most, *readNumber(token));
    }
    shapes[kind].insert(withoutRepetitions(shape));
}

bool isSaidIn(const corpus::Line& line, const char* words) {
    return line.source.find(words) != std::string::npos;
}

/// Lines that real servers sent, and lines in the format of their source where there is no capture.
Wire captured(const std::string& dialect) {
    Wire wire;
    for (const corpus::Line& line : corpus::infoLines()) {
        const bool of_dialect = line.source.find(dialect) != std::string::npos;
        const bool is_conf = line.text.starts_with("CONF");
        const bool three_decimals = isSaidIn(line, "3-decimal") && !is_conf;
        const bool in_format = line.captured || isSaidIn(line, "(constructed");
        // No capture has UT2004's answers. MOAST's comments quote some, with two or four decimals of ScanInterval.
        const bool quoted = dialect == "UT2004" && isSaidIn(line, "MOAST") &&
                            line.text.find("ScanInterval") == std::string::npos &&
                            (is_conf || line.text.starts_with("GEO"));
        if (of_dialect && !three_decimals && (in_format || quoted))
            wire.read(line.text);
    }
    return wire;
}

/// Pairs of kinds in the order in which they stand within a tick, which begins with the state in UDK and ends with it
/// in UT2004.
using Order = std::set<std::pair<std::string, std::string>>;

Order orderIn(const std::vector<std::string>& lines, bool state_is_first) {
    Order order;
    std::vector<std::string> tick;
    for (const std::string& line : lines) {
        const std::string kind = kindOf(line);
        if (!kind.starts_with("SEN") && kind != "STA" && kind != "MISSTA")
            continue;
        if (kind == "STA" && state_is_first)
            tick.clear();
        for (const std::string& before : tick)
            if (before != kind)
                order.insert({before, kind});
        tick.push_back(kind);
        if (kind == "STA" && !state_is_first)
            tick.clear();
    }
    return order;
}

Order capturedOrder(const std::string& dialect) {
    std::vector<std::string> lines;
    for (const corpus::Line& line : corpus::infoLines())
        if (line.captured && line.source.find(dialect) != std::string::npos && isSaidIn(line, "in order"))
            lines.push_back(line.text);
    return orderIn(lines, dialect == "UDK");
}

/// Returns what a robot of the profile sends while it drives a bow forward and then turns on the spot both ways, and is
/// asked about itself.
std::vector<std::string> linesOf(protocol::Dialect profile, const std::string& class_name) {
    constexpr std::array asked{"Camera", "Robot", "INS", "RangeScanner"};
    SimulationOptions options;
    options.profile = profile;
    options.tick = Seconds{profile == protocol::Dialect::Udk ? 0.1 : 0.2};
    const auto simulation = simulationOf(flatWorld(), options);
    Talker talker(*simulation);
    talker.say("INIT {ClassName USARBot." + class_name + "} {Name R1} {Location 0,0,-0.3}");
    std::vector<std::string> lines;
    for (int tick = 0; tick < 150; ++tick) {
        if (tick % 50 == 10)
            talker.say(tick < 50    ? "DRIVE {Left 2} {Right 1}"
                       : tick < 100 ? "DRIVE {Left -3} {Right 3}"
                                    : "DRIVE {Left 3} {Right -3}");
        if (tick >= 20 && tick < 20 + static_cast<int>(asked.size()))
            for (const char* const word : {"GETCONF", "GETGEO"})
                if (tick > 20 || word == std::string("GETCONF")) // No capture has a camera on a mount that moves.
                    talker.say(std::string(word) + " {Type " + asked[static_cast<std::size_t>(tick - 20)] + "}");
        simulation->step();
        std::ranges::move(talker.hearText(), std::back_inserter(lines));
    }
    return lines;
}

Wire sent(protocol::Dialect profile, const std::string& class_name) {
    Wire wire;
    for (const std::string& line : linesOf(profile, class_name))
        wire.read(line);
    return wire;
}

} // namespace

class tst_WireAsCaptured : public QObject {
    Q_OBJECT
private slots:
    void wordsOrderAndDecimalsAreThoseOfTheCaptures_data() { profiles(); }
    void wordsOrderAndDecimalsAreThoseOfTheCaptures() {
        QFETCH(const QString, dialect);
        QFETCH(const QString, robot);
        const Wire real = captured(dialect.toStdString());
        const Wire ours = sent(profileOf(dialect), robot.toStdString());
        int compared = 0;
        QStringList wrong;
        for (const auto& [kind, shapes] : ours.shapes) {
            const auto known = real.shapes.find(kind);
            if (known == real.shapes.end())
                continue;
            ++compared;
            for (const std::string& shape : shapes)
                if (!known->second.contains(shape))
                    wrong << QString("sent:     %1\ncaptured: %2")
                                 .arg(QString::fromStdString(shape), QString::fromStdString(*known->second.begin()));
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
        QVERIFY2(compared >= 6, qPrintable(QString("%1 kinds were compared").arg(compared)));
    }

    void eachFieldHasItsDecimalsAndItsRange_data() { profiles(); }
    void eachFieldHasItsDecimalsAndItsRange() {
        QFETCH(const QString, dialect);
        QFETCH(const QString, robot);
        const Wire real = captured(dialect.toStdString());
        const Wire ours = sent(profileOf(dialect), robot.toStdString());
        QStringList wrong;
        for (const auto& [kind, fields] : ours.fields)
            for (const auto& [name, field] : fields) {
                if (!real.fields.contains(kind) || !real.fields.at(kind).contains(name))
                    continue;
                const Field& known = real.fields.at(kind).at(name);
                const QString row =
                    QString("%1 %2: captured %3; sent %4").arg(kind.c_str(), name.c_str(), known.text(), field.text());
                qInfo("%s", qPrintable(row));
                if (!std::ranges::includes(known.decimals, field.decimals) || !isWithin(dialect, kind, name, field))
                    wrong << row;
            }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
    }

    void linesOfATickHaveTheOrderOfTheCaptures_data() { profiles(); }
    void linesOfATickHaveTheOrderOfTheCaptures() {
        QFETCH(const QString, dialect);
        QFETCH(const QString, robot);
        const Order real = capturedOrder(dialect.toStdString());
        int compared = 0;
        QStringList wrong;
        for (const auto& [first, second] :
             orderIn(linesOf(profileOf(dialect), robot.toStdString()), dialect == "UDK")) {
            const bool so = real.contains({first, second});
            compared += so ? 1 : 0;
            if (!so && real.contains({second, first}))
                wrong << QString("%1 comes before %2").arg(first.c_str(), second.c_str());
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
        QVERIFY2(compared >= 10, qPrintable(QString("%1 pairs were compared").arg(compared)));
    }

    void noZeroWithFourDecimalsIsNegative_data() { profiles(); }
    void noZeroWithFourDecimalsIsNegative() {
        QFETCH(const QString, dialect);
        QFETCH(const QString, robot);
        SimulationOptions options;
        options.profile = profileOf(dialect);
        const auto simulation = simulationOf(flatWorld(), options);
        Talker talker(*simulation);
        talker.say("INIT {ClassName USARBot." + robot.toStdString() + "} {Name R1} {Location 0,0,-0.3}");
        talker.say("DRIVE {Left -1} {Right -1}");
        steps(*simulation, 60);
        for (const std::string& line : talker.hearText())
            QVERIFY2(line.find("-0.0000") == std::string::npos, line.c_str());
    }

    /// A robot at rest on level ground where the map begins has many zeros; half a turn between the frames negates
    /// them.
    void noZeroOfUt2004IsNegative() {
        const auto simulation = simulationOf(flatWorld());
        Talker talker(*simulation);
        talker.say("INIT {ClassName USARBot.P2DX} {Name R1} {Location 0,0,-0.3}");
        talker.say("GETSTARTPOSES");
        steps(*simulation, 2);
        for (const std::string& line : talker.hearText())
            if (kindOf(line) == "SEN INS" || kindOf(line) == "NFO" || kindOf(line) == "SEN Odometry")
                QVERIFY2(line.find("-0.00") == std::string::npos, line.c_str());
    }

private:
    static void profiles() {
        QTest::addColumn<QString>("dialect");
        QTest::addColumn<QString>("robot");
        QTest::newRow("a P2DX of UT2004") << "UT2004"
                                          << "P2DX";
        QTest::newRow("a P2AT of UDK") << "UDK"
                                       << "P2AT";
        QTest::newRow("the captured P3AT of UDK") << "UDK"
                                                  << "P3AT";
    }
    static protocol::Dialect profileOf(const QString& dialect) {
        return dialect == "UDK" ? protocol::Dialect::Udk : protocol::Dialect::Ut2004;
    }
    /// Angles of a turn: [0, 2 pi) but for ground truth of UDK, which is (-pi, pi] (protocol.md 3).
    static bool isWithin(const QString& dialect, const std::string& kind, const std::string& name, const Field& field) {
        if (name.starts_with("Orientation") && kind.starts_with("SEN")) {
            const bool signed_turn = dialect == "UDK" && kind == "SEN GroundTruth";
            return signed_turn ? field.least >= -3.15 && field.most <= 3.15 : field.least >= 0.0 && field.most <= 6.29;
        }
        if (kind == "SEN Sonar" && name == "Range")
            return field.least >= 0.1 && field.most <= 5.0;
        return true;
    }
};

USAR_TEST(tst_WireAsCaptured)

} // namespace tst_wire_as_captured

#include "tst_wire_as_captured.moc"
