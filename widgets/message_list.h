// Every line in and out, newest at the bottom: searched, filtered, held still, copied.
#pragma once

#include <deque>

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "widgets/models/message_model.h"

namespace usar::widgets {

class EmptyState;

/// Takes lines at any rate and shows them with one insertion a frame; hidden or paused it only keeps them. Stays at
/// the end until the person scrolls up; then the content stands still, also while old lines fall out. Lines with
/// diagnostics have a sign and a color, and say the reason as tooltip; commands say who sent them and on which line.
/// GUI thread.
class MessageList : public QWidget {
    Q_OBJECT
public:
    explicit MessageList(QWidget* parent = nullptr);

    /// `time` is the protocol's clock when it came or went.
    void takeLine(const protocol::InfoLine& line, Seconds time);
    /// `dialect` is the one in which it was written on the wire.
    void takeCommand(const agent::CausedCommand& command, Seconds time,
                     protocol::Dialect dialect = protocol::Dialect::Ut2004);
    /// So many lines were left out here; one row says so, and adds up while nothing comes between.
    void takeNotShown(std::uint64_t count);
    /// Sets search box and direction choice as well.
    void setFilter(const MessageFilter& filter);
    bool paused() const { return pause_->isChecked(); }

    const MessageModel& model() const { return *model_; }
    QTableView* view() const { return view_; }
    /// Says whether there are no lines at all or none that fits.
    EmptyState* emptyState() const { return empty_state_; }
    QSize sizeHint() const override { return {640, 240}; }
    QSize minimumSizeHint() const override { return {280, 120}; }

public slots:
    /// The list stands still; lines are kept, the newest 100 000 of them, and their number is shown.
    void setPaused(bool paused);
    /// Takes all lines away, kept ones too; filter and pause stay.
    void clear();

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeTools();
    void setUpView();
    void setUpActions();
    void keep(MessageRow row);
    /// Starts the frame timer, if there is somebody to see it.
    void flushSoon();
    void flush();
    void applyFilter();
    void copySelected(bool text_only);
    void filterLikeCurrent();
    void updateState();

    MessageModel* model_;
    QTableView* view_;
    QLineEdit* search_;
    QComboBox* way_;
    QLabel* count_;
    QToolButton* pause_ = nullptr;
    EmptyState* empty_state_;
    std::deque<MessageRow> waiting_; ///< at most the model's capacity
    std::uint64_t overflown_ = 0;    ///< lines that fell out of `waiting_`
    std::uint64_t commands_ = 0;     ///< taken so far: their numbers
    QTimer frame_{this};
};

} // namespace usar::widgets
