// SPDX-License-Identifier: MIT
// A deck of slides by keyboard, mouse or touch. The slides are in the page already, each with its notes; a class of
// the root says how they are seen (deck.css): deck, and with it overview, with-notes, idle.
(() => {
  'use strict';
  const root = document.documentElement;
  root.classList.add('deck', 'idle');

  const start = () => {
    const byId = (id) => document.getElementById(id);
    // In the language of the slides.
    const words = JSON.parse(document.body.dataset.words);
    const filled = (text, ...parts) => text.replace(/\{(\d)\}/g, (part, i) => parts[i]);
    const slides = [...document.querySelectorAll('.slide')];
    const bar = byId('bar'), keys = byId('keys'), typed = byId('typed'), status = byId('status');
    const last = slides.length - 1;
    const is = (name) => root.classList.contains(name);
    let wanted = 0;  // the slide asked for last; shown as soon as it is decoded
    let digits = '';

    const image = (index) => slides[index]?.querySelector('img');
    // Ready to be painted at once. A picture that cannot be decoded is shown as what it is, with its words.
    const decoded = (index) => image(index)?.decode().catch(() => {});

    const stageOf = (index) => slides[index].dataset.stage;
    const startOfStage = (index) => {
      while (index > 0 && stageOf(index - 1) === stageOf(index)) --index;
      return index;
    };
    const nextStage = (index) => {
      const found = slides.findIndex((_, i) => i > index && stageOf(i) !== stageOf(index));
      return found < 0 ? last : found;
    };
    const previousStage = (index) => {
      const first = startOfStage(index);
      return first < index || first === 0 ? first : startOfStage(first - 1);
    };

    const idIn = (hash) => hash.slice(1).split('?')[0];
    // A slide that moves, and what moves it, have their own clicks, fingers and keys.
    const isLive = (target) => target.closest?.('.live-view, .live-panel, .live-press, .live-why');

    const say = (text) => { status.textContent = text; };

    const mark = (index) => {
      const reading = document.activeElement?.classList.contains('notes');
      slides.forEach((slide, i) => {
        slide.classList.toggle('current', i === index);
        if (i === index) slide.setAttribute('aria-current', 'true');
        else slide.removeAttribute('aria-current');
      });
      const title = slides[index].getAttribute('aria-label');
      byId('place').textContent = `${index + 1} / ${slides.length}`;
      byId('where').textContent = title;
      byId('back').disabled = index === 0;
      byId('next').disabled = index === last;
      say(filled(words.slide, index + 1, slides.length, title));
      if (reading) slides[index].querySelector('.notes')?.focus({preventScroll: true});
      // What stands behind it in an address is the figure's (assets/web/figures.js).
      if (idIn(location.hash) !== slides[index].id) history.replaceState(null, '', '#' + slides[index].id);
    };

    // The slide before stays until the picture can be painted: nothing flashes.
    const show = async (index) => {
      wanted = Math.max(0, Math.min(last, index));
      const now = wanted;
      if (!is('overview')) await decoded(now);
      if (now !== wanted) return;
      mark(now);
      if (is('overview')) choose();
      else for (const next of [now + 1, now - 1]) decoded(next);
    };

    // In the overview the chosen slide has the focus.
    const choose = () => {
      const link = slides[wanted].querySelector('a');
      link.focus({preventScroll: true});
      slides[wanted].scrollIntoView({block: 'nearest'});
    };
    const columns = () => {
      const top = slides[0].offsetTop;
      const below = slides.findIndex((slide) => slide.offsetTop > top);
      return below < 0 ? slides.length : below;
    };

    const press = (id, on) => byId(id).setAttribute('aria-pressed', String(on));

    const setOverview = async (on) => {
      if (on === is('overview')) return;
      if (!on) await decoded(wanted);
      root.classList.toggle('overview', on);
      press('overview', on);
      if (on) {
        choose();
        slides[wanted].scrollIntoView({block: 'center'});
      } else {
        document.activeElement?.blur();
      }
      mark(wanted);
    };
    const setNotes = (on) => {
      root.classList.toggle('with-notes', on);
      press('notes', on);
      if (!on && document.activeElement?.classList.contains('notes')) document.activeElement.blur();
    };
    const setHelp = (on) => {
      if (on && !keys.open) keys.showModal();
      if (!on) keys.close();
    };
    const toggleFull = () => {
      const done = document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen?.();
      done?.catch(() => {});
    };

    const type = (text) => {
      digits = text;
      typed.textContent = filled(words.typed, digits);
      typed.hidden = digits === '';
    };

    const close = () => {
      if (digits !== '') type('');
      else if (is('overview')) setOverview(false);
      else if (is('with-notes')) setNotes(false);
      else return false;
      return true;
    };

    const move = (event) => {
      const stages = event.shiftKey;
      const across = is('overview');
      switch (event.key) {
        case 'ArrowRight': return stages ? nextStage(wanted) : wanted + 1;
        case 'ArrowLeft': return stages ? previousStage(wanted) : wanted - 1;
        case 'ArrowDown': return across ? (wanted + columns() <= last ? wanted + columns() : wanted) : nextStage(wanted);
        case 'ArrowUp': return across ? (wanted >= columns() ? wanted - columns() : wanted) : previousStage(wanted);
        case 'PageDown': return wanted + 1;
        case 'PageUp': return wanted - 1;
        case ' ': return event.shiftKey ? wanted - 1 : wanted + 1;
        case 'Backspace': return wanted - 1;
        case 'Home': return 0;
        case 'End': return last;
        default: return null;
      }
    };

    // Enter opens what was typed; else it does what it does on a link or button; else it goes on.
    const enter = (target) => {
      if (digits !== '') {
        const number = Number(digits);
        type('');
        if (number < 1 || number > slides.length) say(filled(words.none, number, slides.length));
        else if (is('overview')) setOverview(false).then(() => show(number - 1));
        else show(number - 1);
        return true;
      }
      if (target.closest('a, button')) return false;
      show(wanted + 1);
      return true;
    };

    const command = (key) => {
      switch (key.toLowerCase()) {
        case 'o': setOverview(!is('overview')); return true;
        case 'n': if (!is('overview')) setNotes(!is('with-notes')); return true;
        case 'f': toggleFull(); return true;
        case '?':
        case 'h': setHelp(true); return true;
        default: return false;
      }
    };

    const kScrolling = ['ArrowUp', 'ArrowDown', 'PageUp', 'PageDown', 'Home', 'End'];

    const onKey = (event) => {
      const {key, target} = event;
      if (event.ctrlKey || event.altKey || event.metaKey || event.isComposing || event.defaultPrevented) return;
      if (keys.open) {
        if (key === '?' || key === 'h') setHelp(false);
        return;
      }
      if (target.closest?.('.notes') && kScrolling.includes(key)) return;
      if (key === ' ' && target.closest?.('button')) return;
      if (target.closest?.('.live-panel') && key !== 'PageDown' && key !== 'PageUp') return;
      let done = true;
      if (/^[0-9]$/.test(key)) {
        type((digits + key).slice(-5));
      } else if (key === 'Backspace' && digits !== '') {
        type(digits.slice(0, -1));
      } else if (key === 'Enter') {
        done = enter(target);
      } else if (key === 'Escape') {
        done = close();
      } else {
        const index = move(event);
        if (index !== null) {
          type('');
          show(index);
        } else {
          done = command(key);
        }
      }
      if (done) event.preventDefault();
    };

    // A swipe is a finger that moves more along than across; what is no swipe is a click.
    const kSwipe = 40;
    let down = null, swiped = false;
    const onDown = (event) => {
      swiped = false;
      down = event.pointerType === 'mouse' || !event.isPrimary || isLive(event.target) ? null : {x: event.clientX, y: event.clientY};
    };
    const onUp = (event) => {
      if (!down || window.visualViewport?.scale > 1.01) return;
      const x = event.clientX - down.x, y = event.clientY - down.y;
      down = null;
      if (Math.abs(x) < kSwipe || Math.abs(x) < 1.5 * Math.abs(y)) return;
      swiped = true;
      show(x < 0 ? wanted + 1 : wanted - 1);
    };
    const onClick = (event) => {
      const slide = event.target.closest('.slide');
      if (!slide) return;
      if (is('overview')) {
        event.preventDefault();
        wanted = slides.indexOf(slide);
        setOverview(false);
        return;
      }
      if (swiped || event.target.closest('.notes') || isLive(event.target) || event.button !== 0) return;
      const box = event.target.getBoundingClientRect();
      show(event.clientX < box.left + box.width / 3 ? wanted - 1 : wanted + 1);
    };

    // Tab goes from slide to slide in the overview.
    const onFocus = (event) => {
      const index = slides.indexOf(event.target.closest?.('.slide'));
      if (!is('overview') || index < 0 || index === wanted) return;
      wanted = index;
      mark(index);
    };

    const kAwake_ms = 2500;
    let asleep = 0;
    const wake = (event) => {
      if (event.pointerType === 'touch') return;
      root.classList.remove('idle');
      clearTimeout(asleep);
      asleep = setTimeout(() => root.classList.add('idle'), kAwake_ms);
    };

    const fromHash = () => {
      const name = idIn(location.hash);
      const found = slides.findIndex((slide) => slide.id === name);
      return found < 0 ? 0 : found;
    };

    if (slides.length === 0) return;
    bar.hidden = false;
    document.addEventListener('keydown', onKey);
    byId('slides').addEventListener('click', onClick);
    byId('slides').addEventListener('focusin', onFocus);
    byId('slides').addEventListener('pointerdown', onDown);
    byId('slides').addEventListener('pointerup', onUp);
    document.addEventListener('pointermove', wake);
    byId('back').addEventListener('click', () => show(wanted - 1));
    byId('next').addEventListener('click', () => show(wanted + 1));
    byId('notes').addEventListener('click', () => setOverview(false).then(() => setNotes(!is('with-notes'))));
    byId('overview').addEventListener('click', () => setOverview(!is('overview')));
    byId('full').addEventListener('click', toggleFull);
    byId('help').addEventListener('click', () => setHelp(true));
    window.addEventListener('hashchange', () => show(fromHash()));
    show(fromHash());
  };

  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', start);
  else start();
})();
