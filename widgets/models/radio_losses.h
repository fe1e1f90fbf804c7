// Which radio links between robots were lost or are back, for notices.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include <QStringList>

#include "widgets/models/radio_links.h"

namespace usar::widgets {

/// Compares each report of signal strengths with the one before. A pair that was never linked has lost nothing. A plain
/// value.
class RadioLosses {
public:
    /// A change of one link.
    struct News {
        QString key;    ///< the same for each change of one pair
        QString reason; ///< why the link was lost and what to do; empty: it is back, or one of the robots is gone
    };

    /// Takes the newest strengths of all pairs; `robots` are the names of those that still exist.
    std::vector<News> take(const std::vector<RadioLink>& links, const QStringList& robots);

private:
    std::map<std::pair<QString, QString>, bool> linked_; ///< last reported state; only pairs that have been linked
};

} // namespace usar::widgets
