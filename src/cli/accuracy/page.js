// A curve is shown if every word of it is.
const form = document.getElementById('filters');
const curves = [...document.querySelectorAll('.curve')];

form.addEventListener('change', () => {
  const boxes = [...form.querySelectorAll('input')];
  for (const curve of curves) {
    const hidden = boxes.some(box => !box.checked && curve.dataset[box.dataset.key] === box.value);
    curve.classList.toggle('hidden', hidden);
  }
});
