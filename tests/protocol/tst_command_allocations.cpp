#include <QTest>

#include "any_command.h"
#include "core/protocol/command_writer.h"
#include "tests/doubles/allocation_counter.h"
#include "tests/suite/suite.h"

namespace tst_command_allocations {

using namespace usar;
using namespace usar::protocol;

class tst_CommandAllocations : public QObject {
    Q_OBJECT
private slots:
    void theCounterCounts();
    void writingIntoATextWithRoomAllocatesNothing_data();
    void writingIntoATextWithRoomAllocatesNothing();
};

void tst_CommandAllocations::theCounterCounts() {
    const std::size_t before = allocations;
    const std::string line = write(GetGeometry{"ASensorTypeThatIsLongerThanAShortText"});
    QVERIFY(allocations > before);
    QVERIFY(!line.empty());
}

void tst_CommandAllocations::writingIntoATextWithRoomAllocatesNothing_data() {
    QTest::addColumn<Dialect>("dialect");
    QTest::newRow("UT2004") << Dialect::Ut2004;
    QTest::newRow("UDK") << Dialect::Udk;
}

void tst_CommandAllocations::writingIntoATextWithRoomAllocatesNothing() {
    QFETCH(Dialect, dialect);
    Random random = seeded(44, 1);
    std::vector<Command> commands;
    for (std::size_t i = 0; i < 100 * any::kinds; ++i)
        commands.push_back(any::command(i % any::kinds, dialect, random));
    std::string out;
    const auto writeAll = [&] {
        out.clear();
        for (const Command& command : commands)
            write(command, dialect, out);
    };
    writeAll(); // makes the room
    const std::size_t before = allocations;
    writeAll();
    const std::size_t made = allocations - before;
    QCOMPARE(made, std::size_t{0});
}

USAR_TEST(tst_CommandAllocations)

} // namespace tst_command_allocations

#include "tst_command_allocations.moc"
