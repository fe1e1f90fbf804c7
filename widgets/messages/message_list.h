// List of every line received and sent, newest at the bottom: search, filter, pause, details, copy, save, send again.
#pragma once

#include <deque>
#include <map>

#include <QAction>
#include <QSplitter>
#include <QTableView>
#include <QTimer>
#include <QWidget>

#include "widgets/messages/message_detail.h"
#include "widgets/messages/message_filter_bar.h"
#include "widgets/models/messages/message_model.h"
#include "widgets/models/messages/message_saver.h"

namespace usar::widgets {

class EmptyState;

/// Actions of the list, which are its children; a command registry may adopt them.
struct MessageActions {
    QAction* copy = nullptr; ///< the columns of the selected rows, separated by tabs
    QAction* copy_text = nullptr;
    QAction* copy_json = nullptr;
    QAction* copy_shown = nullptr;
    QAction* save = nullptr;
    QAction* resend = nullptr; ///< enabled if a command is selected
    QAction* only_type = nullptr;
    QAction* hide_type = nullptr;
    QAction* no_filter = nullptr;
    QAction* cause = nullptr;   ///< goes to the line that made us send the selected command
    QAction* details = nullptr; ///< checkable, like all below except clear
    QAction* only_trouble = nullptr;
    QAction* pause = nullptr;
    QAction* follow = nullptr;
    QAction* all_robots = nullptr;
    QAction* clear = nullptr; ///< not checkable
};

/// Accepts lines at any rate and inserts them at most once per frame; while hidden or paused it only stores them. Stays
/// at the end until the user scrolls up or clicks a line; then the content stays in place, even while old lines are
/// removed. Lines with diagnostics have an icon and a color, and their tooltip says why; commands say who sent them and
/// in reply to which line. Stores the lines of all connections; shows those of the selected one, or all. GUI thread.
class MessageList : public QWidget {
    Q_OBJECT
public:
    explicit MessageList(QWidget* parent = nullptr);
    ~MessageList() override;

    /// `time` is the protocol clock at arrival; `connection` is any number that identifies the connection.
    void takeLine(const protocol::InfoLine& line, Seconds time, ConnectionId connection = {});
    /// `text` is the command as it went over the wire.
    void takeCommand(std::string text, const Cause& cause, Seconds time, ConnectionId connection = {});
    /// Reports that `count` lines were left out here; consecutive reports are added up in one row.
    void takeNotShown(std::uint64_t count, ConnectionId connection = {});
    /// Name of the robot on that connection.
    void nameConnection(ConnectionId connection, const QString& name) { model_->nameConnection(connection, name); }
    /// Shows the lines of this connection, unless those of all connections are shown.
    void selectConnection(ConnectionId connection);
    /// Also sets the tool bar above the list; `filter.connection` is ignored.
    void setFilter(const MessageFilter& filter) { bar_->setFilter(filter); }
    bool paused() const { return actions_.pause->isChecked(); }
    /// Starts saving the shown rows as text, or as JSON lines if the name ends in ".jsonl". The list stands still until
    /// `saved` or `failed` is emitted.
    void saveShown(const QString& path);
    void focusSearch() { bar_->focusSearch(); }
    /// Selects the row with that serial number of the model and shows its details; filters that hide it are removed.
    void jumpTo(std::uint64_t serial);
    /// The same with the newest info line that has this number; false: the list does not have it, or no longer.
    bool jumpToLine(ConnectionId connection, LineNumber line);
    /// Protocol clock of that line, even if it is not inserted yet; nullopt: as above, or it was not known.
    std::optional<Seconds> timeOf(ConnectionId connection, LineNumber line) const;

    const MessageModel& model() const { return *model_; }
    QTableView* view() const { return view_; }
    MessageDetail* detail() const { return detail_; }
    MessageFilterBar* bar() const { return bar_; }
    const MessageActions& actions() const { return actions_; }
    QSize sizeHint() const override { return {640, 240}; }
    QSize minimumSizeHint() const override { return {226, 120}; }

public slots:
    /// Removes all lines, also those not inserted yet; filter and pause stay.
    void clear();

signals:
    /// The selected commands, oldest first; `connection` is that of the first one, and commands of others are left out.
    void resendRequested(usar::ConnectionId connection, const QStringList& lines);
    void saveRequested();
    void saved(const QString& path, int lines);
    void failed(const QString& reason);
    /// "1,234 of 100,000 lines, 12 waiting".
    void countChanged(const QString& text);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void makeActions();
    void wireActions();
    void setUpView();
    void wireView();
    /// Stores a row; beyond the capacity the oldest ones are dropped and counted.
    void keep(MessageRow row, ConnectionId connection);
    /// Starts the frame timer if the list is visible.
    void flushSoon();
    void flush();
    std::vector<MessageRow> takeBatch();
    void applyFilter();
    /// Keeps the list at its end or at the selected row after the filter has changed.
    void keepPlace();
    void noteSelection();
    /// The selected rows, oldest first, at most `limit`; pointers are valid until the model changes.
    std::vector<const MessageRow*> selectedRows(std::size_t limit = SIZE_MAX) const;
    using RowText = QString (*)(const MessageRow& row, const QString& robot);
    void copyRows(const std::vector<const MessageRow*>& rows, RowText text);
    void copyShown();
    void resend();
    /// Shows only, or hides, the type of the first selected row.
    void filterByCurrent(bool only);
    void updateState();
    void enableActions();

    MessageModel* model_ = new MessageModel(this);
    MessageActions actions_;
    MessageFilterBar* bar_ = nullptr;
    QSplitter* splitter_ = new QSplitter(this);
    QTableView* view_ = new QTableView(splitter_);
    MessageDetail* detail_ = new MessageDetail(splitter_);
    MessageSaver* saver_ = new MessageSaver(*model_, this);
    EmptyState* empty_state_ = nullptr;
    std::deque<MessageRow> waiting_;                 ///< rows not inserted yet; at most the model's capacity
    std::size_t waiting_bytes_ = 0;                  ///< size of their text
    std::uint64_t overflown_ = 0;                    ///< lines dropped from `waiting_`
    std::map<ConnectionId, std::uint64_t> commands_; ///< number of commands taken so far, by connection
    ConnectionId connection_;
    std::optional<std::uint64_t> selected_; ///< serial number of the current row, even while it is not shown
    bool moving_ = false;                   ///< the list scrolls by itself, not the user
    QTimer frame_{this};
};

} // namespace usar::widgets
