// The numbers of names.
#include <string>
#include <vector>

#include <QTest>

#include "core/posh/model/number_table.h"
#include "tests/suite/suite.h"

namespace tst_number_table {

using usar::posh::NumberTable;

namespace {

/// Names, and the table that numbers them in the order in which they come.
struct Names {
    std::vector<std::string> names;
    NumberTable table;

    auto nameOf() {
        return [this](NumberTable::Number number) -> const std::string& { return names[number]; };
    }
    NumberTable::Number note(const std::string& name) {
        const auto fresh = static_cast<NumberTable::Number>(names.size());
        const auto number = table.findOrNote(name, fresh, nameOf());
        if (number == fresh)
            names.push_back(name);
        return number;
    }
    NumberTable::Number find(const std::string& name) { return table.find(name, nameOf()); }
};

} // namespace

class tst_NumberTable : public QObject {
    Q_OBJECT
private slots:
    void knowsNothingBeforeTheFirstName() {
        Names names;
        QCOMPARE(names.find("go"), NumberTable::none);
        QCOMPARE(names.find(""), NumberTable::none);
    }

    void tellsApartNamesOfAllLengths() {
        Names names;
        std::string name;
        for (NumberTable::Number length = 0; length < 200; ++length, name += 'x')
            QCOMPARE(names.note(name), length);
        QCOMPARE(names.note(std::string(77, 'x')), 77U);
        QCOMPARE(names.find(std::string(200, 'x')), NumberTable::none);
    }

    void tellsApartNamesThatDifferInOneLetterAnywhere() {
        for (const std::size_t length : {1U, 3U, 4U, 7U, 8U, 9U, 16U, 23U}) {
            Names names;
            QCOMPARE(names.note(std::string(length, 'a')), 0U);
            for (std::size_t at = 0; at < length; ++at) {
                std::string other(length, 'a');
                other[at] = 'b';
                QCOMPARE(names.note(other), static_cast<NumberTable::Number>(at + 1));
            }
            QCOMPARE(names.note(std::string(length, 'a')), 0U);
        }
    }

    void keepsTheFirstNumberOfEachWhileItGrows() {
        Names names;
        for (NumberTable::Number i = 0; i < 20'000; ++i)
            QCOMPARE(names.note("name-" + std::to_string(i)), i);
        for (NumberTable::Number i = 0; i < 20'000; ++i)
            QCOMPARE(names.note("name-" + std::to_string(i)), i);
        QCOMPARE(names.find("name-20000"), NumberTable::none);
    }
};

USAR_TEST(tst_NumberTable)

} // namespace tst_number_table

#include "tst_number_table.moc"
