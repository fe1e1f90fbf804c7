// Every line in and out, newest at the bottom: searched, filtered, held still, taken apart, copied, saved, sent again.
#pragma once

#include <deque>
#include <map>

#include <QAction>
#include <QLabel>
#include <QSplitter>
#include <QTableView>
#include <QTimer>
#include <QWidget>

#include "widgets/message_detail.h"
#include "widgets/message_filter_bar.h"
#include "widgets/models/message_model.h"
#include "widgets/models/message_saver.h"

namespace usar::widgets {

class EmptyState;

/// What can be done with the list; a command registry may adopt them. Children of the list.
struct MessageActions {
    QAction* copy = nullptr; ///< the columns of the selected rows, with tabs
    QAction* copy_text = nullptr;
    QAction* copy_json = nullptr;
    QAction* copy_shown = nullptr;
    QAction* save = nullptr;
    QAction* resend = nullptr; ///< on where a command is selected
    QAction* only_type = nullptr;
    QAction* hide_type = nullptr;
    QAction* no_filter = nullptr;
    QAction* cause = nullptr;   ///< to the line that made us send the selected command
    QAction* details = nullptr; ///< checkable, as all below
    QAction* only_trouble = nullptr;
    QAction* pause = nullptr;
    QAction* follow = nullptr;
    QAction* all_robots = nullptr;
    QAction* clear = nullptr; ///< not checkable
};

/// Takes lines at any rate and shows them with one insertion a frame; hidden or paused it only keeps them. Stays at
/// the end until the person scrolls up or clicks a line; then the content stands still, also while old lines fall out.
/// Lines with
/// diagnostics have a sign and a color, and say the reason as tooltip; commands say who sent them and on which line.
/// Lines of many connections are kept together; those of the selected one are shown, or all. GUI thread.
class MessageList : public QWidget {
    Q_OBJECT
public:
    explicit MessageList(QWidget* parent = nullptr);
    ~MessageList() override;

    /// `time` is the protocol's clock when it came or went; `connection` any number, the same for all of its lines.
    void takeLine(const protocol::InfoLine& line, Seconds time, int connection = 0);
    /// `text` as it went over the wire.
    void takeCommand(std::string text, const Cause& cause, Seconds time, int connection = 0);
    /// So many lines were left out here; one row says so, and adds up while nothing comes between.
    void takeNotShown(std::uint64_t count, int connection = 0);
    /// The robot that speaks there.
    void nameConnection(int connection, const QString& name);
    /// The one whose lines are shown, unless all are.
    void selectConnection(int connection);
    /// Sets the tools above the list as well; its connection is not looked at.
    void setFilter(const MessageFilter& filter);
    bool paused() const { return actions_.pause->isChecked(); }
    /// The shown rows as text, or as JSON where the name ends in ".jsonl". The list stands still meanwhile.
    void saveShown(const QString& path);
    void focusSearch() { bar_->focusSearch(); }
    /// Selects that row of the model's and shows its details; filters that hide it are taken off.
    void jumpTo(std::uint64_t serial);

    const MessageModel& model() const { return *model_; }
    QTableView* view() const { return view_; }
    MessageDetail* detail() const { return detail_; }
    MessageFilterBar* bar() const { return bar_; }
    const MessageActions& actions() const { return actions_; }
    /// Says whether there are no lines at all or none that fits.
    EmptyState* emptyState() const { return empty_state_; }
    QSize sizeHint() const override { return {640, 240}; }
    QSize minimumSizeHint() const override { return {280, 120}; }

public slots:
    /// The list stands still; lines are kept, the newest 100 000 of them, and their number is shown.
    void setPaused(bool paused);
    /// Takes all lines away, kept ones too; filter and pause stay.
    void clear();

signals:
    /// Selected commands, oldest first; `connection` is the one over which the first of them went.
    void resendRequested(int connection, const QStringList& lines);
    void saveRequested();
    void saved(const QString& path, int lines);
    void failed(const QString& reason);
    /// "1,234 of 100,000 lines, 12 waiting".
    void countChanged(const QString& text);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void makeActions();
    QAction* makeAction(const QString& text, const QString& help, const QString& icon_name = {});
    QAction* makeToggle(const QString& text, const QString& help, const QString& icon_name, bool on);
    void wireActions();
    void setUpView();
    void wireView();
    void keep(MessageRow row);
    /// Starts the frame timer, if there is somebody to see it.
    void flushSoon();
    void flush();
    std::vector<MessageRow> takeBatch();
    void applyFilter();
    void keepPlace();
    void noteSelection();
    /// Oldest first, so many at most.
    std::vector<const MessageRow*> selectedRows(std::size_t limit = SIZE_MAX) const;
    using RowText = QString (*)(const MessageRow& row, const QString& robot);
    void copyRows(const std::vector<const MessageRow*>& rows, RowText text);
    void copyShown();
    void resend();
    void filterByCurrent(bool only);
    void updateState();
    void enableActions();

    MessageModel* model_;
    MessageActions actions_;
    MessageFilterBar* bar_ = nullptr;
    QSplitter* splitter_;
    QTableView* view_;
    MessageDetail* detail_;
    MessageSaver* saver_;
    EmptyState* empty_state_ = nullptr;
    std::deque<MessageRow> waiting_;        ///< at most the model's capacity
    std::size_t waiting_bytes_ = 0;         ///< of text
    std::uint64_t overflown_ = 0;           ///< lines that fell out of `waiting_`
    std::map<int, std::uint64_t> commands_; ///< taken so far, by connection: their numbers
    int connection_ = 0;
    std::optional<std::uint64_t> selected_; ///< serial number of the current row, also while it is not shown
    bool moving_ = false;                   ///< the list scrolls by itself
    QTimer frame_{this};
};

} // namespace usar::widgets
