// What a campaign has shown, in words: which variant is better, by how much, and what is still open.
#pragma once

#include <vector>

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>

#include "widgets/style/empty_state.h"

namespace usar::widgets {

/// The word on one figure: "better", "worse", "equal", "not worse" or "undecided", of the candidate.
struct VerdictWord {
    QString title;
    QString word;
    QString detail;
    bool operator==(const VerdictWord&) const = default;
};

/// A variant against the first one.
struct CampaignVerdict {
    QString headline;
    std::vector<VerdictWord> words;
    QStringList notes; ///< They say what was not compared.
    bool operator==(const CampaignVerdict&) const = default;
};

/// GUI thread.
class VerdictView : public QWidget {
    Q_OBJECT
public:
    explicit VerdictView(QWidget* parent = nullptr);

    /// Shows these verdicts. Without any, `instead` says why there is none.
    void setVerdicts(const std::vector<CampaignVerdict>& verdicts, const QString& instead);
    void setAction(QAction* report);
    /// The whole text without formatting.
    QString text() const;

private:
    void write();

    std::vector<CampaignVerdict> verdicts_;
    QLabel* text_ = new QLabel;
    QPushButton* report_ = new QPushButton(tr("Write and open report"), this);
    QScrollArea* scroll_;
    EmptyState* nothing_;
};

} // namespace usar::widgets
