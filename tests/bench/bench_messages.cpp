// What the message list costs with 100,000 lines in it, beside the two usual ways: a standard item model in a table,
// and a plain text edit.
#include <benchmark/benchmark.h>

#include <QApplication>
#include <QHeaderView>
#include <QImage>
#include <QPlainTextEdit>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QTableView>

#include "widgets/messages/message_list.h"

using namespace usar;
using namespace usar::widgets;

namespace {

constexpr int rows_held = 100'000;
constexpr int rows_a_frame = 330; // 20,000 lines a second at 60 frames

/// One application for all benches; no window system is needed to paint into a picture. A base, so that it is there
/// before any view.
struct Application {
    Application() {
        if (qApp)
            return;
        qputenv("QT_QPA_PLATFORM", "offscreen");
        static int argc = 1;
        static char name[] = "usar-bench";
        static char* argv[] = {name, nullptr};
        new QApplication(argc, argv); // lives as long as the program
    }
};

std::string text(std::uint64_t number) {
    const std::string start = number % 10 == 0 ? "SEN {Time 751.20} {Type Sonar}" : "STA {Type AerialVehicle}";
    return start +
           " {Time 751.20} {Location 1.25,-2.50,-6.00} {Orientation 0.00,0.00,6.28} {Velocity 0.10,0.00,0.00} " +
           std::to_string(number);
}

std::vector<MessageRow> rows(std::uint64_t first, int count) {
    std::vector<MessageRow> batch;
    for (int i = 0; i < count; ++i) {
        MessageRow row;
        row.number = first + static_cast<std::uint64_t>(i);
        row.text = text(row.number);
        row.type = typeOf(row.text);
        batch.push_back(std::move(row));
    }
    return batch;
}

/// Shown, so that views keep their layout; painted into a picture as a window would be.
template <class View>
void show(View& view) {
    view.resize(1920, 1080);
    view.show();
    QApplication::sendPostedEvents();
}

void setUp(QTableView& view) {
    view.setWordWrap(false);
    view.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    view.horizontalHeader()->setStretchLastSection(true);
    show(view);
}

struct Ours : Application {
    Ours() {
        view.setModel(&model);
        setUp(view);
        model.append(rows(0, rows_held));
    }
    void append(std::uint64_t first) {
        model.append(rows(first, rows_a_frame));
        view.scrollToBottom();
    }
    MessageModel model;
    QTableView view;
};

struct Standard : Application {
    Standard() {
        view.setModel(&proxy);
        proxy.setSourceModel(&model);
        proxy.setFilterKeyColumn(5);
        setUp(view);
        add(0, rows_held);
    }
    void add(std::uint64_t first, int count) {
        for (const MessageRow& row : rows(first, count)) {
            QList<QStandardItem*> items;
            for (const QString& cell :
                 {QString::number(row.number), QStringLiteral("0.00"), QStringLiteral("R1"), QStringLiteral("in"),
                  QString::fromStdString(row.type), QString::fromStdString(row.text)})
                items << new QStandardItem(cell);
            model.appendRow(items);
        }
    }
    void append(std::uint64_t first) {
        model.removeRows(0, rows_a_frame);
        add(first, rows_a_frame);
        view.scrollToBottom();
    }
    QStandardItemModel model;
    QSortFilterProxyModel proxy;
    QTableView view;
};

struct PlainText : Application {
    PlainText() {
        view.setMaximumBlockCount(rows_held);
        view.setLineWrapMode(QPlainTextEdit::NoWrap);
        show(view);
        QStringList lines;
        for (const MessageRow& row : rows(0, rows_held))
            lines << QString::fromStdString(row.text);
        view.setPlainText(lines.join(u'\n'));
    }
    void append(std::uint64_t first) {
        for (const MessageRow& row : rows(first, rows_a_frame))
            view.appendPlainText(QString::fromStdString(row.text));
    }
    QPlainTextEdit view;
};

/// A frame's lines come in, the oldest go, and the window is painted.
template <class List>
void messageFrame(benchmark::State& state) {
    List list;
    QImage frame(list.view.size(), QImage::Format_ARGB32_Premultiplied);
    std::uint64_t next = rows_held;
    for ([[maybe_unused]] auto _ : state) {
        list.append(next);
        next += rows_a_frame;
        list.view.render(&frame);
    }
}
BENCHMARK(messageFrame<Ours>)->Name("messages: 330 more of 100,000, painted at 1080p")->Unit(benchmark::kMillisecond);
BENCHMARK(messageFrame<Standard>)
    ->Name("messages: the same in a standard item model")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(20);
BENCHMARK(messageFrame<PlainText>)
    ->Name("messages: the same in a plain text edit")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(20);

void messageFilter(benchmark::State& state) {
    Ours list;
    bool one = false;
    for ([[maybe_unused]] auto _ : state) {
        list.model.setFilter({.words = (one = !one) ? QStringLiteral("sonar") : QStringLiteral("aerial")});
        list.model.finishFilter();
    }
}
BENCHMARK(messageFilter)->Name("messages: another filter over 100,000, to its end")->Unit(benchmark::kMillisecond);

/// What a person waits for: the newest rows that fit.
void messageFilterSeen(benchmark::State& state) {
    Ours list;
    bool one = false;
    for ([[maybe_unused]] auto _ : state)
        list.model.setFilter({.words = (one = !one) ? QStringLiteral("sonar") : QStringLiteral("aerial")});
}
BENCHMARK(messageFilterSeen)->Name("messages: another filter, until rows are seen")->Unit(benchmark::kMillisecond);

void messageFilterStandard(benchmark::State& state) {
    Standard list;
    bool one = false;
    for ([[maybe_unused]] auto _ : state)
        list.proxy.setFilterFixedString((one = !one) ? QStringLiteral("Sonar") : QStringLiteral("Aerial"));
}
BENCHMARK(messageFilterStandard)
    ->Name("messages: another filter by a proxy model")
    ->Unit(benchmark::kMillisecond)
    ->Iterations(6);

} // namespace
