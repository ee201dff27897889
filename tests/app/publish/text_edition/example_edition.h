// SPDX-License-Identifier: MIT
// A lesson with one of everything that a text edition has.
#pragma once

namespace polhode {

inline constexpr const char* kEditionLesson = R"lesson(+++
format = 1
id     = "edition"
title  = "An <edition> & more"
author = ["A. B."]
language = "en"
outcomes = ["read it"]
[references]
LL = "Landau & Lifshitz"
[symbols]
omega = { tex = '\vec\omega', role = "omega", say = "angular velocity", unit = "rad/s" }
[scene]
body   = "textbook"
omega  = [0.2, 0.1, 3.0]
+++
# How $\vec\omega$ moves {moves}
## The first step
First **words**, *others*, `code <b>`, [a link](https://example.org/?a=1&b=2), [there](#asked), [elsewhere](other#x) and
[cite: LL, §36][^n]. At $t = 0$ it turns at $\live[unit={rad/s}]{norm(omega)}$.

- one
- two
  1. inside
  2. twice
- three

| body | period |
|:--|--:|
| coin | $0.2$ s |

[^n]: A note with $\vec\omega$.

```math law
\term{rate}{\frac{d\vec L}{dt}} = \vec N \tag{5}
```
```claim law law
ddt(L) = N
```
```scene
show    = ["energy-ellipsoid", "omega"]
caption = 'It turns at $\live[unit={rad/s}]{norm(omega)}$'
at      = 0.5
```
---
> [!said] It **stops**.

The same picture, by $\eqref{law}$.

# Questions {asked}
```scene
omega = [0.0, 0.0, 2.0]
show  = ["omega"]
caption = 'It keeps to $\value[unit={rad/s}]{2.00}{norm(omega)}$'
```
```ask pick
type    = "choice"
prompt  = "Which is it?"
choices = ["One & only.", 'Two $\vec\omega$.']
answer  = 2
because = 'It is \<two>.'
hints   = ["Guess."]
```
```ask rank
type    = "order"
prompt  = "Order them."
choices = ["small", "large", "middle"]
answer  = [1, 3, 2]
```
```ask count
type    = "number"
prompt  = "How fast?"
answer  = "norm(omega)"
unit    = "rad/s"
```
```ask write
type    = "expression"
prompt  = "Write the energy."
answer  = "I1*w1"
```
)lesson";

}  // namespace polhode
