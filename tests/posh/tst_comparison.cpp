// Truth and comparison of what senses answer.
#include <QTest>

#include <limits>

#include "core/posh/run/comparison.h"
#include "core/posh/run/value_text.h"
#include "tests/suite/suite.h"

namespace tst_comparison {

using namespace usar::posh;

namespace {

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct Row {
    const char* claim;
    Value answer;
    Predicate predicate;
    Value operand;
    Comparison expected;
};

const std::vector<Row> rows{
    {"a whole number equals a float", std::int64_t{5}, Predicate::Equal, 5.0, Comparison::Holds},
    {"true counts as one", true, Predicate::Equal, std::int64_t{1}, Comparison::Holds},
    {"false is less than a half", false, Predicate::Less, 0.5, Comparison::Holds},
    {"nil equals nil", {}, Predicate::Equal, {}, Comparison::Holds},
    {"nil does not equal false", {}, Predicate::Equal, false, Comparison::Fails},
    {"nil does not equal zero", {}, Predicate::Equal, std::int64_t{0}, Comparison::Fails},
    {"nil differs from zero", {}, Predicate::NotEqual, std::int64_t{0}, Comparison::Holds},
    {"nil does not equal an empty text", {}, Predicate::Equal, std::string(), Comparison::Fails},
    {"a symbol equals the text of its letters", Symbol{"red"}, Predicate::Equal, std::string("red"), Comparison::Holds},
    {"a number never equals a text", std::int64_t{3}, Predicate::Equal, std::string("3"), Comparison::Fails},
    {"a number differs from a text", std::int64_t{3}, Predicate::NotEqual, std::string("3"), Comparison::Holds},
    {"texts have the order of their code points", std::string("ab"), Predicate::Less, std::string("b"),
     Comparison::Holds},
    {"letters beyond ASCII come last", std::string("\xc3\xa9"), Predicate::Greater, std::string("z"),
     Comparison::Holds},
    {"symbols have no order", Symbol{"a"}, Predicate::Less, Symbol{"b"}, Comparison::Unlike},
    {"a number and a text have no order", 1.0, Predicate::LessOrEqual, std::string("1"), Comparison::Unlike},
    {"nil has no order", {}, Predicate::Less, std::int64_t{1}, Comparison::Unlike},
    {"at most", std::int64_t{2}, Predicate::LessOrEqual, 2.0, Comparison::Holds},
    {"at least", 1.9, Predicate::GreaterOrEqual, std::int64_t{2}, Comparison::Fails},
    {"not-a-number equals nothing", not_a_number, Predicate::Equal, not_a_number, Comparison::Fails},
    {"not-a-number differs from itself", not_a_number, Predicate::NotEqual, not_a_number, Comparison::Holds},
    {"not-a-number has no place in the order", not_a_number, Predicate::LessOrEqual, 1.0, Comparison::Fails},
};

const std::vector<std::tuple<const char*, Value, bool>> truths{
    {"nil", {}, false},
    {"false", false, false},
    {"zero", std::int64_t{0}, false},
    {"0.0", 0.0, false},
    {"-0.0", -0.0, false},
    {"not-a-number", not_a_number, false},
    {"the empty text", std::string(), false},
    {"true", true, true},
    {"five", std::int64_t{5}, true},
    {"a tenth", 0.1, true},
    {"the text 0", std::string("0"), true},
    {"a symbol, even false", Symbol{"false"}, true},
};

const std::vector<std::tuple<const char*, Value, const char*>> texts{
    {"nil", {}, "nil"},
    {"a whole float keeps one decimal", 2.0, "2.0"},
    {"a float is as short as it can be", 0.1, "0.1"},
    {"a round float has no exponent", 100000.0, "100000.0"},
    {"nor has a small one", 0.0001, "0.0001"},
    {"a negative zero", -0.0, "-0.0"},
    {"a large float", 1e300, "1e+300"},
    {"a tiny float", 2.5e-7, "2.5e-07"},
    {"infinity", std::numeric_limits<double>::infinity(), "inf"},
    {"a whole number", std::int64_t{-7}, "-7"},
    {"a text in quotes", std::string("a \"b\"\n\x01"), "\"a \\\"b\\\"\\n\\u0001\""},
    {"a symbol", Symbol{"a.b"}, "'a.b"},
};

} // namespace

class tst_Comparison : public QObject {
    Q_OBJECT
private slots:
    void comparesAs_data();
    void comparesAs();
    void isTrueWhen_data();
    void isTrueWhen();
    void isWritten_data();
    void isWritten();
};

void tst_Comparison::comparesAs_data() {
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < rows.size(); ++i)
        QTest::newRow(rows[i].claim) << static_cast<int>(i);
}

void tst_Comparison::comparesAs() {
    QFETCH(int, row);
    const Row& here = rows[static_cast<std::size_t>(row)];
    QCOMPARE(compare(here.answer, here.predicate, here.operand), here.expected);
}

void tst_Comparison::isTrueWhen_data() {
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < truths.size(); ++i)
        QTest::newRow(std::get<0>(truths[i])) << static_cast<int>(i);
}

void tst_Comparison::isTrueWhen() {
    QFETCH(int, row);
    const auto& [claim, value, expected] = truths[static_cast<std::size_t>(row)];
    QCOMPARE(truthOf(value), expected);
}

void tst_Comparison::isWritten_data() {
    QTest::addColumn<int>("row");
    for (std::size_t i = 0; i < texts.size(); ++i)
        QTest::newRow(std::get<0>(texts[i])) << static_cast<int>(i);
}

void tst_Comparison::isWritten() {
    QFETCH(int, row);
    const auto& [claim, value, expected] = texts[static_cast<std::size_t>(row)];
    QCOMPARE(QString::fromStdString(toText(value)), QString(expected));
}

USAR_TEST(tst_Comparison)

} // namespace tst_comparison

#include "tst_comparison.moc"
